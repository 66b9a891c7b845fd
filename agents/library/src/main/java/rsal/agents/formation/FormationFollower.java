package rsal.agents.formation;

import java.time.Duration;
import java.time.Instant;
import java.util.function.BooleanSupplier;
import rsal.agent.AgentContext;
import rsal.agents.driving.NavigationClient;
import rsal.agents.formation.FormationSlots.Slot;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;

/// Keeps a robot at its place in a formation, as its leader says ([FormationSlots]). Errands come first.
/// When nothing is heard of the formation any more, it lets go of the robot.
final class FormationFollower {
    private static final Duration SILENCE = Duration.ofSeconds(3);
    private static final Duration LOOK = Duration.ofSeconds(1);
    private static final Tolerance CLOSE = Tolerance.position(0.15);
    private static final double SAME = 0.05; // m; not worth a new goal

    private final AgentContext self;
    private final String robot;
    private final NavigationClient driver;
    private final BooleanSupplier isBusy;
    private final Runnable before;
    private final Runnable after;
    private Instant heard = Instant.MIN;
    private boolean keeping;

    /// @param isBusy whether the robot does something else that comes first
    /// @param before lets go of the robot; called when it joins a formation
    /// @param after takes it back; called when the formation is no more heard of and it is not busy
    FormationFollower(
            AgentContext self,
            String robot,
            NavigationClient driver,
            BooleanSupplier isBusy,
            Runnable before,
            Runnable after) {
        this.self = self;
        this.robot = robot;
        this.driver = driver;
        this.isBusy = isBusy;
        this.before = before;
        this.after = after;
    }

    void begin() {
        self.subscribe(FormationSlots.TOPIC, message -> {
            Slot slot = message.content().slots().get(robot);
            if (slot != null) {
                heard = message.time();
                keep(slot, message.content().shape());
            }
        });
        self.scheduler().every(LOOK, this::look);
    }

    private void keep(Slot slot, String shape) {
        if (isBusy.getAsBoolean()) {
            keeping = false;
            return;
        }
        if (!keeping) {
            keeping = true;
            before.run();
        }
        self.state("keeping its place in a " + shape);
        Pose2d aim = slot.mapFromAim();
        boolean onItsWay =
                driver.mapFromGoal().filter(goal -> goal.distanceTo(aim) < SAME).isPresent();
        if (!onItsWay) {
            driver.goTo(aim, CLOSE, _ -> {});
        }
    }

    private void look() {
        boolean over = keeping && heard.plus(SILENCE).isBefore(self.scheduler().instant());
        if (over) {
            keeping = false;
            if (!isBusy.getAsBoolean()) {
                driver.stop();
                after.run();
            }
        }
    }
}
