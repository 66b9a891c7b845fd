package rsal.scenario.condition;

import java.util.Collection;
import java.util.List;
import java.util.stream.Stream;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.SignalType;

/// What expressions of a scenario can ask of its runs, in the order in which people are told.
///
/// @param isOpen whether there are metrics that are not read, so that a word may be one of theirs
public record MetricWords(List<QuantityType> quantities, List<SignalType> signals, boolean isOpen) {
    /// What every run knows of itself.
    public static final MetricWords OF_RUNS = new MetricWords(RunQuantities.ALL, RunQuantities.SIGNALS, false);

    public MetricWords {
        quantities = List.copyOf(quantities);
        signals = List.copyOf(signals);
    }

    /// These and those of metrics.
    public static MetricWords of(Collection<MetricType> metrics, boolean isOpen) {
        return new MetricWords(
                Stream.concat(OF_RUNS.quantities.stream(), metrics.stream().flatMap(type -> type.quantities().stream()))
                        .toList(),
                Stream.concat(OF_RUNS.signals.stream(), metrics.stream().flatMap(type -> type.signals().stream()))
                        .toList(),
                isOpen);
    }

    List<QuantityType> countingAll() {
        return quantities.stream().filter(QuantityType::countsAll).toList();
    }

    List<String> quantityWords() {
        return quantities.stream().map(QuantityType::word).toList();
    }

    /// Words with which a condition can begin.
    List<String> predicates() {
        return Stream.of(
                        countingAll().stream().map(QuantityType::wordForAll),
                        quantityWords().stream(),
                        Stream.of("not"))
                .flatMap(words -> words)
                .toList();
    }

    /// Words of what there are samples of.
    List<String> sampled() {
        return Stream.concat(signals.stream().map(SignalType::word), quantityWords().stream())
                .toList();
    }
}
