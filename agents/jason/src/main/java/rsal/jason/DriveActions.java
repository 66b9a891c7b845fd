package rsal.jason;

import java.time.Duration;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.agent.AgentContext;
import rsal.behavior.LimitSpeed;
import rsal.behavior.LimitTurnRate;
import rsal.behavior.Pilot;
import rsal.behavior.SetSpeed;
import rsal.behavior.Subsumption;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.robot.Robot;
import rsal.time.Task;

/// Drives a robot by one of its navigator, its pilot and plain commands at a time. The newest counts, and none outlives
/// the agent.
final class DriveActions {
    private static final Duration AGAIN = Duration.ofMillis(200); // bases stop 0.5 s after the last command
    private static final double MOST_SPEED = 1.0; // m/s
    private static final double MOST_TURN = 1.0; // rad/s
    private static final double STOP_DISTANCE = 0.1; // m

    private final AgentContext self;
    private final Robot robot;
    private @Nullable GoalHandle<Progress, Result> way;
    private @Nullable Task command;

    DriveActions(AgentContext self, Robot robot) {
        this.self = self;
        this.robot = robot;
        self.atEnd(this::letGo);
    }

    /// @param onEnd told on the agent's lane
    GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance, Consumer<Result> onEnd) {
        endCommand();
        robot.find(Pilot.class).ifPresent(Pilot::release);
        GoalHandle<Progress, Result> next = robot.require(Navigator.class).goTo(mapFromGoal, tolerance);
        way = next;
        next.result()
                .thenAccept(result -> self.scheduler().execute(() -> {
                    if (next.equals(way)) {
                        way = null;
                    }
                    onEnd.accept(result);
                }));
        return next;
    }

    void drive(Twist2d velocity) {
        if (robot.find(Pilot.class).isPresent()) {
            behave(new Subsumption()
                    .layer("drive", new SetSpeed(velocity))
                    .layer("limit-turn-rate", new LimitTurnRate(robot.model().footprint(), MOST_TURN))
                    .layer("limit-speed", new LimitSpeed(robot.model().footprint(), MOST_SPEED, STOP_DISTANCE)));
            return;
        }
        letGo();
        var base = robot.require(DriveBase.class);
        base.command(velocity);
        command = self.scheduler().every(AGAIN, () -> base.command(velocity));
    }

    void behave(Subsumption stack) {
        endWay();
        endCommand();
        robot.require(Pilot.class).engage(stack);
    }

    void stop() {
        letGo();
        robot.require(DriveBase.class).command(Twist2d.STOP);
    }

    private void letGo() {
        endWay();
        endCommand();
        robot.find(Pilot.class).ifPresent(Pilot::release);
    }

    private void endWay() {
        GoalHandle<Progress, Result> last = way;
        way = null;
        if (last != null) {
            last.cancel();
        }
    }

    private void endCommand() {
        Task last = command;
        command = null;
        if (last != null) {
            last.cancel();
        }
    }
}
