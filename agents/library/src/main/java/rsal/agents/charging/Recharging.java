package rsal.agents.charging;

import java.util.List;
import java.util.Optional;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import rsal.agent.AgentContext;
import rsal.agents.driving.NavigationClient;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.robot.Robot;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Minds the battery of a robot that works: takes it to a charger when it runs low, as soon as it can leave what it
/// does, and gives it back when it is full ([Charging]).
public final class Recharging {
    public static final Parameter<List<Point2d>> CHARGERS = Parameter.places(
            "chargers",
            "Places at which robots are charged; a robot stands there while it charges. Empty: robots are never"
                    + " charged.");
    public static final Parameter<Double> LOW = Parameter.number(
            "lowBattery", 0.3, 0, 1, "", "Charge below which it drives to a charger, as a share of the full battery.");
    public static final Parameter<Double> FULL = Parameter.number(
            "fullBattery", 0.9, 0, 1, "", "Charge at which it resumes its work, as a share of the full battery.");

    public static final Parameter<Double> RANGE = Parameter.number(
            "batteryRange",
            150,
            1,
            1e6,
            "m",
            "Distance that it can drive on a full battery, with all its other work. It does not begin tasks that need"
                    + " more.");

    private final AgentContext self;
    private final Charging charging;
    private final BooleanSupplier canLeave;
    private final Runnable before;
    private final Runnable after;
    private boolean atIt;

    /// @param canLeave whether the robot can go to a charger now
    /// @param before lets go of the robot; called when its battery is low
    /// @param after takes it back; called when it is full
    public Recharging(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            Supplier<Optional<Pose2d>> mapFromBase,
            Arguments arguments,
            BooleanSupplier canLeave,
            Runnable before,
            Runnable after) {
        this.self = self;
        this.charging = charging(self, robot, driver, mapFromBase, arguments);
        this.canLeave = canLeave;
        this.before = before;
        this.after = after;
    }

    /// As an agent's arguments have it.
    public static Charging charging(
            AgentContext self,
            Robot robot,
            NavigationClient driver,
            Supplier<Optional<Pose2d>> mapFromBase,
            Arguments arguments) {
        return new Charging(
                self, robot, driver, mapFromBase, arguments.get(CHARGERS), arguments.get(LOW), arguments.get(FULL));
    }

    public void begin() {
        charging.begin(this::look);
    }

    /// Whether it has the robot.
    public boolean isCharging() {
        return atIt;
    }

    /// Whether the battery is being charged, or is so low that it must be.
    public boolean isNeeded() {
        return charging.isNeeded();
    }

    /// How far the robot can drive before it must have been charged [m]; +∞ when it never is.
    ///
    /// @param range on a full battery [m]
    public double reach(double range) {
        return charging.reach(range);
    }

    private void look() {
        if (!atIt && charging.isNeeded() && canLeave.getAsBoolean()) {
            atIt = true;
            before.run();
            charging.start();
        } else if (atIt && !charging.isNeeded()) {
            atIt = false;
            charging.stop();
            self.state("charged");
            after.run();
        }
    }
}
