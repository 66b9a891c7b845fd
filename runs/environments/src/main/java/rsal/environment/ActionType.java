package rsal.environment;

import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of action, such as velocities. Found by [java.util.ServiceLoader].
public interface ActionType extends Plugin {
    /// @param arguments for [#parameters]
    /// @throws IllegalArgumentException in a sentence for people, when they do not fit together
    LearnerAction create(Arguments arguments);
}
