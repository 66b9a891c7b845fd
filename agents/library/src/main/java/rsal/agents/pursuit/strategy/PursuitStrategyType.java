package rsal.agents.pursuit.strategy;

import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of pursuit strategies. Found by [java.util.ServiceLoader], or a Java file that a scenario names
/// (`strategy: Mine.java`).
public interface PursuitStrategyType extends Plugin {
    /// One for each hunter.
    ///
    /// @param arguments for [#parameters]
    PursuitStrategy create(Arguments arguments);
}
