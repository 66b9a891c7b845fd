package rsal.experiment;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.OptionalDouble;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.jspecify.annotations.Nullable;
import rsal.experiment.Manifest.MetricEntry;
import rsal.experiment.statistics.Effect;
import rsal.experiment.statistics.Effect.Pair;
import rsal.settings.InvalidSettings;

/// What is known of an experiment: what it is, and the results of its runs so far.
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

    /// What was measured in a run; of a metric that each robot has, the mean over its robots, as those of
    /// one run are not independent of each other. Empty where there was nothing to measure.
    public OptionalDouble value(Row row, MetricEntry metric) {
        if (!metric.perRobot()) {
            return row.metrics().getOrDefault(metric.name(), OptionalDouble.empty());
        }
        return row.metrics().entrySet().stream()
                .filter(value -> value.getKey().startsWith(metric.name() + "."))
                .filter(value -> value.getValue().isPresent())
                .mapToDouble(value -> value.getValue().getAsDouble())
                .average();
    }

    /// What was measured in all runs, as it can be averaged and compared.
    public MetricSamples measurements(MetricEntry metric) {
        return MetricSamples.of(this, metric);
    }

    /// What a report compares: other levels of each of [Design#compared].
    public List<Change> changes() {
        return design().compared().stream()
                .flatMap(factor -> Change.of(factor).stream())
                .toList();
    }

    /// What a change does to a metric: over all combinations of what is varied besides, by seed.
    public Effect effect(Change change, MetricSamples measurements) {
        return Effect.of(blocks(change, measurements::of, _ -> true));
    }

    /// The same for what it does to the share of runs that end in some way, in percentage points: a run that ends so
    /// counts for 100, another one for 0.
    public Effect effectOnShare(Change change, String outcome) {
        return Effect.of(blocks(change, row -> OptionalDouble.of(row.outcome().equals(outcome) ? 100 : 0), _ -> true));
    }

    /// What it does to a metric where another factor has some level.
    public Effect effectWhere(Change change, Factor other, String level, MetricSamples measurements) {
        return Effect.of(blocks(change, measurements::of, with(other, level)));
    }

    private static Predicate<Combination> with(Factor factor, String level) {
        return combination -> combination.level(factor.argument()).equals(level);
    }

    /// Two changes of different factors, each pair of those from their first levels.
    public List<Interaction> interactions() {
        List<Factor> factors = design().compared();
        var interactions = new ArrayList<Interaction>();
        for (int i = 0; i < factors.size(); i++) {
            for (Factor other : factors.subList(i + 1, factors.size())) {
                for (Change change : Change.fromFirst(factors.get(i))) {
                    Change.fromFirst(other).forEach(where -> interactions.add(new Interaction(change, where)));
                }
            }
        }
        return interactions;
    }

    /// Whether what a change does depends on another one.
    public record Interaction(Change change, Change where) {
        /// `strategy a → b, where hunters 1 → 3`
        @Override
        public String toString() {
            return change + ", where " + where;
        }
    }

    /// How much more a change does after the other one: the difference of two differences, by seed. D. Montgomery,
    /// Design and Analysis of Experiments, 8th edition, section 5.1.
    public Effect effect(Interaction interaction, MetricSamples measurements) {
        Factor other = interaction.where().factor();
        List<List<Pair>> before = blocks(
                interaction.change(),
                measurements::of,
                with(other, interaction.where().from()));
        List<List<Pair>> after = blocks(
                interaction.change(),
                measurements::of,
                with(other, interaction.where().to()));
        return Effect.of(IntStream.range(0, before.size())
                .mapToObj(seed -> changes(before.get(seed), after.get(seed)))
                .toList());
    }

    private static List<Pair> changes(List<Pair> before, List<Pair> after) {
        return IntStream.range(0, before.size())
                .mapToObj(i -> new Pair(before.get(i).change(), after.get(i).change()))
                .toList();
    }

    /// By seed: a pair for each combination of the others, in the order of the design.
    private List<List<Pair>> blocks(Change change, Function<Row, OptionalDouble> value, Predicate<Combination> among) {
        var rowOf = new HashMap<Long, Map<Integer, Row>>(); // by seed and combination
        rows.forEach(
                row -> rowOf.computeIfAbsent(row.seed(), _ -> new HashMap<>()).put(row.combination(), row));
        Map<Combination, Combination> changed = changed(change, among);
        var blocks = new ArrayList<List<Pair>>();
        for (long seed : design().seeds()) {
            Map<Integer, Row> here = rowOf.getOrDefault(seed, Map.of());
            blocks.add(changed.entrySet().stream()
                    .map(both -> new Pair(
                            valueIfThere(here.get(both.getKey().number()), value),
                            valueIfThere(here.get(both.getValue().number()), value)))
                    .toList());
        }
        return blocks;
    }

    private static OptionalDouble valueIfThere(@Nullable Row row, Function<Row, OptionalDouble> value) {
        return row != null ? value.apply(row) : OptionalDouble.empty();
    }

    /// From each combination before a change to the one after it.
    private Map<Combination, Combination> changed(Change change, Predicate<Combination> among) {
        Factor factor = change.factor();
        var before = new HashMap<List<String>, Combination>();
        var after = new HashMap<List<String>, Combination>();
        for (Combination combination : design().combinations()) {
            List<String> others = others(combination, factor);
            if (combination.level(factor.argument()).equals(change.from())) {
                before.put(others, combination);
            } else if (combination.level(factor.argument()).equals(change.to()) && among.test(combination)) {
                after.put(others, combination);
            }
        }
        var changed = new TreeMap<Combination, Combination>(Comparator.comparingInt(Combination::number));
        after.forEach((others, to) -> changed.put(Objects.requireNonNull(before.get(others)), to));
        return changed;
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
