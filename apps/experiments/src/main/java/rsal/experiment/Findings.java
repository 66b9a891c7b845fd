package rsal.experiment;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.Function;
import org.jspecify.annotations.Nullable;
import rsal.experiment.Manifest.Measure;
import rsal.experiment.statistics.Effect;
import rsal.experiment.statistics.Effect.Pair;
import rsal.experiment.statistics.Mean;
import rsal.settings.InvalidSettings;

/// What is known of an experiment: what it is, and what came of its runs so far.
///
/// @param rows in the order of the design, whichever ended first
public record Findings(Manifest manifest, List<Row> rows) {
    public Findings {
        rows = List.copyOf(rows);
    }

    /// Reads them from a folder, also while the experiment goes on.
    ///
    /// @throws InvalidSettings when there are none, or they can't be read
    public static Findings read(Path folder) {
        return new Findings(SweepFolder.manifest(folder), SweepFolder.rows(folder));
    }

    public Design design() {
        return manifest.subject().design();
    }

    /// Those of a combination.
    public List<Row> of(Combination combination) {
        return rows.stream()
                .filter(row -> row.combination() == combination.number())
                .toList();
    }

    /// What a combination is called among the others.
    public String label(Combination combination) {
        return manifest.subject().configurations().size() > 1 ? combination.toString() : combination.levelsOnly();
    }

    /// The same of several.
    public List<String> labels(List<Combination> combinations) {
        return combinations.stream().map(this::label).toList();
    }

    /// What was measured in a run; of a measure that each robot has, the mean over its robots, as those of
    /// one run are not independent of each other. Empty where there was nothing to measure.
    public OptionalDouble value(Row row, Measure measure) {
        if (!measure.perRobot()) {
            return row.measures().getOrDefault(measure.name(), OptionalDouble.empty());
        }
        return row.measures().entrySet().stream()
                .filter(value -> value.getKey().startsWith(measure.name() + "."))
                .filter(value -> value.getValue().isPresent())
                .mapToDouble(value -> value.getValue().getAsDouble())
                .average();
    }

    /// What was measured in the runs of a combination in which there was something.
    public double[] values(Combination combination, Measure measure) {
        return of(combination).stream()
                .map(row -> value(row, measure))
                .filter(OptionalDouble::isPresent)
                .mapToDouble(OptionalDouble::getAsDouble)
                .toArray();
    }

    /// Of these; empty when there are none.
    public Optional<Mean> mean(Combination combination, Measure measure) {
        double[] values = values(combination, measure);
        return values.length == 0 ? Optional.empty() : Optional.of(Mean.of(values));
    }

    /// What it does to a measure when a factor has another level than its first, and all else is the same:
    /// over all combinations of the others, by seed.
    ///
    /// @param factor one of [Design#compared]
    public Effect effect(Factor factor, String level, Measure measure) {
        return effect(factor, level, (Row row) -> value(row, measure));
    }

    /// Likewise what it does to the share of runs that end in some way, in percentage points: a run that ends so counts
    /// for 100, another one for 0.
    public Effect effectOnShare(Factor factor, String level, String outcome) {
        return effect(
                factor, level, (Row row) -> OptionalDouble.of(row.outcome().equals(outcome) ? 100 : 0));
    }

    private Effect effect(Factor factor, String level, Function<Row, OptionalDouble> value) {
        var rowOf = new HashMap<Long, Map<Integer, Row>>(); // by seed and combination
        rows.forEach(
                row -> rowOf.computeIfAbsent(row.seed(), _ -> new HashMap<>()).put(row.combination(), row));
        Map<Combination, Combination> changes = changes(factor, level);
        var blocks = new ArrayList<List<Pair>>();
        for (long seed : design().seeds()) {
            Map<Integer, Row> here = rowOf.getOrDefault(seed, Map.of());
            blocks.add(changes.entrySet().stream()
                    .map(change -> new Pair(
                            valueIfThere(here.get(change.getKey().number()), value),
                            valueIfThere(here.get(change.getValue().number()), value)))
                    .toList());
        }
        return Effect.of(blocks);
    }

    private static OptionalDouble valueIfThere(@Nullable Row row, Function<Row, OptionalDouble> value) {
        return row != null ? value.apply(row) : OptionalDouble.empty();
    }

    /// From each combination with the factor's first level to the one that is the same but for it.
    private Map<Combination, Combination> changes(Factor factor, String level) {
        var first = new HashMap<List<String>, Combination>();
        var changed = new HashMap<List<String>, Combination>();
        for (Combination combination : design().combinations()) {
            List<String> others = others(combination, factor);
            if (combination.level(factor.argument()).equals(factor.levels().getFirst())) {
                first.put(others, combination);
            } else if (combination.level(factor.argument()).equals(level)) {
                changed.put(others, combination);
            }
        }
        var changes = new TreeMap<Combination, Combination>(Comparator.comparingInt(Combination::number));
        changed.forEach((others, to) -> changes.put(Objects.requireNonNull(first.get(others)), to));
        return changes;
    }

    private List<String> others(Combination combination, Factor factor) {
        return design().compared().stream()
                .map(Factor::argument)
                .filter(name -> !name.equals(factor.argument()))
                .map(combination::level)
                .toList();
    }

    /// Whether all runs have ended.
    public boolean isComplete() {
        return rows.size() == design().trials().size();
    }
}
