package rsal.settings;

import java.util.List;
import java.util.Optional;

/// A part that people choose by its name, or write themselves, as a controller of a navigator. It declares what
/// can be set of it. Those of an installation are found by [java.util.ServiceLoader].
public interface Plugin {
    /// What people call it, as `dwa`; unique among those of its kind.
    String key();

    /// A sentence about what it does.
    String description();

    /// What can be set.
    default List<Parameter<?>> parameters() {
        return List.of();
    }

    /// Why it can't work with such values for its [#parameters], in a sentence for people; empty when it can.
    default Optional<String> refusal(Arguments arguments) {
        return Optional.empty();
    }
}
