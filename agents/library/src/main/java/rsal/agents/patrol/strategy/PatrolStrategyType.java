package rsal.agents.patrol.strategy;

import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of patrol strategies. Found by [java.util.ServiceLoader], or a Java file that a scenario names
/// (`strategy: Mine.java`).
public interface PatrolStrategyType extends Plugin {
    /// One for each robot.
    ///
    /// @param arguments for [#parameters]
    PatrolStrategy create(Arguments arguments);
}
