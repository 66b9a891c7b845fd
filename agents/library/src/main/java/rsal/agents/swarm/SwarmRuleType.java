package rsal.agents.swarm;

import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of swarm rules. Found by [java.util.ServiceLoader], or a Java file that a scenario names (`rule:
/// Mine.java`).
public interface SwarmRuleType extends Plugin {
    /// One for each robot.
    ///
    /// @param arguments for [#parameters]
    SwarmRule create(Arguments arguments);
}
