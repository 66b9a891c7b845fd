package rsal.environment;

import rsal.settings.Arguments;
import rsal.settings.Plugin;

/// A kind of numbers that a learner observes, such as ranges of a laser. Found by [java.util.ServiceLoader].
public interface ObservationType extends Plugin {
    /// @param arguments for [#parameters]
    /// @throws IllegalArgumentException in a sentence for people, when they do not fit together
    LearnerObservation create(Arguments arguments);
}
