package rsal.navigation.control;

import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of progress checkers: what decides whether a robot makes progress. Found by [java.util.ServiceLoader], or a
/// Java file that a scenario names (`navigator: {progressChecker: Mine.java}`).
public interface ProgressCheckerType extends Plugin {
    /// One for each goal.
    ///
    /// @param arguments for [#parameters]
    ProgressChecker create(Arguments arguments);
}
