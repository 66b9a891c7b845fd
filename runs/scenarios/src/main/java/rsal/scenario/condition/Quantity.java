package rsal.scenario.condition;

import java.util.List;
import java.util.stream.Collectors;
import rsal.metric.QuantityType;

/// A number that a run has at any instant. As text it is as people write it: `time`, `caught(prey)`,
/// `distance(prey, hunter)`.
///
/// @param names of what it is, as [QuantityType#names] says; empty where it is of the whole run
public record Quantity(QuantityType type, List<String> names) {
    public Quantity {
        names = List.copyOf(names);
    }

    /// One of the whole run.
    public static Quantity of(QuantityType type) {
        return new Quantity(type, List.of());
    }

    @Override
    public String toString() {
        return names.isEmpty()
                ? type.word()
                : names.stream().map(Quantity::written).collect(Collectors.joining(", ", type.word() + "(", ")"));
    }

    private static String written(String name) {
        return QuantityType.WORD.matcher(name).matches() ? name : '"' + name + '"';
    }
}
