package rsal.navigation.control;

import java.util.List;
import rsal.data.Angles;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A goal is reached within its tolerance.
public final class ToleranceGoalCheckerType implements GoalCheckerType {
    private static final Parameter<Double> LEAVING = Parameter.number(
            "leaving",
            1.3,
            1,
            10,
            "",
            "maximum distance from the goal while the robot turns there, as a" + " multiple of the tolerance");

    @Override
    public String key() {
        return "tolerance";
    }

    @Override
    public String description() {
        return "A goal is reached when the robot is within the tolerance of the goal: a distance and an angle.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(LEAVING);
    }

    @Override
    public GoalChecker create(Arguments arguments, Pose2d mapFromGoal, Tolerance tolerance) {
        return new WithinTolerance(mapFromGoal, tolerance, arguments.get(LEAVING));
    }

    /// Stays at the place until it is farther away: a robot that turns there must not begin to drive again.
    static final class WithinTolerance implements GoalChecker {
        private final Pose2d mapFromGoal;
        private final Tolerance tolerance;
        private final double leaving;
        private boolean isThere;

        WithinTolerance(Pose2d mapFromGoal, Tolerance tolerance, double leaving) {
            this.mapFromGoal = mapFromGoal;
            this.tolerance = tolerance;
            this.leaving = leaving;
        }

        @Override
        public boolean isAtPlace(Pose2d mapFromBase, Twist2d velocity) {
            isThere = mapFromBase.distanceTo(mapFromGoal) <= (isThere ? leaving : 1.0) * tolerance.distance();
            return isThere;
        }

        @Override
        public boolean isReached(Pose2d mapFromBase, Twist2d velocity) {
            return Math.abs(Angles.difference(mapFromBase.theta(), mapFromGoal.theta())) <= tolerance.angle();
        }
    }
}
