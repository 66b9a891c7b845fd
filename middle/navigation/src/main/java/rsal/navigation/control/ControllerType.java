package rsal.navigation.control;

import rsal.data.Footprint;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of controllers (local planners): what drives a robot along its planned way and around what is in the
/// way. Found by [java.util.ServiceLoader], or a Java file that a scenario names:
/// `navigator: {controller: Mine.java}`.
public interface ControllerType extends Plugin {
    /// What a controller drives.
    ///
    /// @param footprint of the robot
    /// @param limits that commands keep
    /// @param lookahead how far ahead on the way the robot aims [m]
    /// @param period between two commands [s]
    /// @param reaction how long the robot takes to do what it is told, at most [s]
    record Driven(Footprint footprint, DriveLimits limits, double lookahead, double period, double reaction) {}

    /// How far around the robot a controller looks [m]; the navigator looks at least as far as it aims.
    default double view(Arguments arguments, Driven driven) {
        return 5;
    }

    /// One for each robot.
    ///
    /// @param arguments for [#parameters]
    Controller create(Arguments arguments, Driven driven);
}
