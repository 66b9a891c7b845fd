package rsal.navigation.control;

import java.util.List;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A goal is reached within its tolerance, once the robot stands still.
public final class StoppedGoalCheckerType implements GoalCheckerType {
    private static final Parameter<Double> SPEED =
            Parameter.number("speed", 0.02, 0, 10, "m/s", "the robot stands still when it is no faster");
    private static final Parameter<Double> TURN_RATE =
            Parameter.number("turnRate", 2, 0, 360, "deg/s", "the robot stands still when it turns no faster");
    private static final double LEAVING = 1.3;

    @Override
    public String key() {
        return "stopped";
    }

    @Override
    public String description() {
        return "A goal is reached when the robot is within the tolerance of the goal, a distance and an angle,"
                + " and stands still.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(SPEED, TURN_RATE);
    }

    @Override
    public GoalChecker create(Arguments arguments, Pose2d mapFromGoal, Tolerance tolerance) {
        var within = new ToleranceGoalCheckerType.WithinTolerance(mapFromGoal, tolerance, LEAVING);
        double speed = arguments.get(SPEED);
        double turnRate = arguments.radians(TURN_RATE);
        return new GoalChecker() {
            @Override
            public boolean isAtPlace(Pose2d mapFromBase, Twist2d velocity) {
                return within.isAtPlace(mapFromBase, velocity);
            }

            @Override
            public boolean isReached(Pose2d mapFromBase, Twist2d velocity) {
                return within.isReached(mapFromBase, velocity)
                        && velocity.speed() <= speed
                        && Math.abs(velocity.omega()) <= turnRate;
            }
        };
    }
}
