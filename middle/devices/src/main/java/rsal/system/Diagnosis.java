package rsal.system;

import java.util.List;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Looks at what is outside of this program and must be right for it, such as a network of robots, and says what to do.
/// Found by [java.util.ServiceLoader] and named by its key: `rsal doctor ros2`.
public interface Diagnosis {
    /// `ros2`
    String key();

    /// For people: a sentence.
    String description();

    /// What may be set: `--set NAME=VALUE`.
    List<Parameter<?>> parameters();

    /// Looks, which may take some seconds. Changes nothing.
    ///
    /// @throws IllegalArgumentException when what is set can't be; its message is a sentence
    List<Finding> look(Arguments settings);

    /// What was found.
    ///
    /// @param what it is about, in one to three words
    /// @param ok false where something does not work
    /// @param found for people
    /// @param remedy what to do; empty when nothing is to be done
    record Finding(String what, boolean ok, String found, String remedy) {}
}
