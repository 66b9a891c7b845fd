package rsal.navigation.control;

import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of goal checkers: what decides when a goal is reached. Found by [java.util.ServiceLoader], or a Java
/// file that a scenario names (`navigator: {goalChecker: Mine.java}`).
public interface GoalCheckerType extends Plugin {
    /// One for each goal.
    ///
    /// @param arguments for [#parameters]
    /// @param tolerance that the goal is sent with
    GoalChecker create(Arguments arguments, Pose2d mapFromGoal, Tolerance tolerance);
}
