package rsal.experiment;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.experiment.Manifest.MetricEntry;
import rsal.experiment.statistics.KaplanMeier;
import rsal.experiment.statistics.Mean;
import rsal.experiment.statistics.Observation;

/// What was measured of one metric in all runs, in values that can be averaged and compared.
///
/// Of a metric that tells when something happened, no run that went on is left out: until it happened, or the run
/// ended ([Observation]). The mean is the one restricted to a horizon up to which all combinations are known, and
/// each run has its share of it ([KaplanMeier#pseudoTimes]): the time itself, cut at the horizon, as long as no run
/// ended before that otherwise. A run with the outcome `failure` is one in which it can never happen any more: it
/// counts to the horizon.
///
/// Of other metrics, runs without a value are left out. So are, of all metrics, runs that broke.
///
/// Immutable.
public final class MetricSamples {
    private static final String FAILURE = "failure";

    private final MetricEntry metric;
    private final OptionalDouble horizon;
    private final Map<Integer, Sample> samples; // by combination

    /// @param runs all of a combination, those that broke too
    /// @param values by number of the run
    /// @param reached runs with a value of their own
    private record Sample(int runs, Map<Integer, Double> values, int reached, Optional<KaplanMeier> curve) {}

    private MetricSamples(MetricEntry metric, OptionalDouble horizon, Map<Integer, Sample> samples) {
        this.metric = metric;
        this.horizon = horizon;
        this.samples = samples;
    }

    static MetricSamples of(Findings findings, MetricEntry metric) {
        var rows = new LinkedHashMap<Integer, List<Row>>();
        findings.rows()
                .forEach(row -> rows.computeIfAbsent(row.combination(), _ -> new ArrayList<>())
                        .add(row));
        return metric.isEventTime() ? ofTimes(findings, metric, rows) : ofValues(findings, metric, rows);
    }

    private static MetricSamples ofValues(Findings findings, MetricEntry metric, Map<Integer, List<Row>> rows) {
        var samples = new HashMap<Integer, Sample>();
        rows.forEach((combination, runs) -> {
            var values = new HashMap<Integer, Double>();
            runs.forEach(row -> findings.value(row, metric).ifPresent(value -> values.put(row.run(), value)));
            samples.put(combination, new Sample(runs.size(), values, values.size(), Optional.empty()));
        });
        return new MetricSamples(metric, OptionalDouble.empty(), samples);
    }

    private static MetricSamples ofTimes(Findings findings, MetricEntry metric, Map<Integer, List<Row>> rows) {
        var observed = new LinkedHashMap<Integer, Map<Integer, Observation>>(); // by combination and run
        rows.forEach((combination, runs) -> {
            var here = new LinkedHashMap<Integer, Observation>();
            runs.forEach(row -> observation(findings, row, metric).ifPresent(seen -> here.put(row.run(), seen)));
            if (!here.isEmpty()) {
                observed.put(combination, here);
            }
        });
        var curves = new HashMap<Integer, KaplanMeier>();
        observed.forEach((combination, here) -> curves.put(combination, KaplanMeier.of(List.copyOf(here.values()))));
        OptionalDouble horizon = horizon(findings, curves);
        var samples = new HashMap<Integer, Sample>();
        rows.forEach((combination, runs) -> {
            Map<Integer, Observation> here = observed.getOrDefault(combination, Map.of());
            Optional<KaplanMeier> curve = Optional.ofNullable(curves.get(combination));
            var values = new HashMap<Integer, Double>();
            curve.ifPresent(known -> {
                double[] times = known.pseudoTimes(List.copyOf(here.values()), horizon.orElseThrow());
                int i = 0;
                for (int run : here.keySet()) {
                    values.put(run, times[i++]);
                }
            });
            samples.put(
                    combination,
                    new Sample(
                            runs.size(),
                            values,
                            curve.map(KaplanMeier::happened).orElse(0),
                            curve));
        });
        return new MetricSamples(metric, horizon, samples);
    }

    /// Nothing of a run that broke.
    private static Optional<Observation> observation(Findings findings, Row row, MetricEntry metric) {
        OptionalDouble time = findings.value(row, metric);
        if (time.isPresent()) {
            return Optional.of(Observation.happened(time.getAsDouble()));
        }
        if (row.outcome().equals(FAILURE)) {
            return Optional.of(Observation.never());
        }
        return row.simulatedSeconds().isPresent()
                ? Optional.of(Observation.censored(row.simulatedSeconds().getAsDouble()))
                : Optional.empty();
    }

    /// Until when all curves are known: the earliest end of them; where all are known for ever, the last end of a
    /// run.
    private static OptionalDouble horizon(Findings findings, Map<Integer, KaplanMeier> curves) {
        double known =
                curves.values().stream().mapToDouble(KaplanMeier::known).min().orElse(Double.POSITIVE_INFINITY);
        return Double.isFinite(known)
                ? OptionalDouble.of(known)
                : findings.rows().stream()
                        .filter(row -> row.simulatedSeconds().isPresent())
                        .mapToDouble(row -> row.simulatedSeconds().getAsDouble())
                        .max();
    }

    public MetricEntry metric() {
        return metric;
    }

    /// Up to when times count [s]; empty when it is not a time of an event, or no run went on.
    public OptionalDouble horizon() {
        return horizon;
    }

    /// What a run adds to the mean; empty when it is left out.
    public OptionalDouble of(Row row) {
        Double value = sample(row.combination()).values().get(row.run());
        return value != null ? OptionalDouble.of(value) : OptionalDouble.empty();
    }

    /// What the runs of a combination add to the mean, those that are left out are missing.
    public double[] of(Combination combination) {
        return sample(combination.number()).values().entrySet().stream()
                .sorted(Map.Entry.comparingByKey())
                .mapToDouble(Map.Entry::getValue)
                .toArray();
    }

    /// Empty when no run has a value.
    public Optional<Mean> mean(Combination combination) {
        double[] values = of(combination);
        return values.length == 0 ? Optional.empty() : Optional.of(Mean.of(values));
    }

    /// In how many runs of a combination there was something to measure.
    public int reached(Combination combination) {
        return sample(combination.number()).reached();
    }

    /// All runs of a combination that ended, those that broke too.
    public int runs(Combination combination) {
        return sample(combination.number()).runs();
    }

    /// Runs of a combination that count in the mean.
    public int used(Combination combination) {
        return sample(combination.number()).values().size();
    }

    /// How many have happened by when; empty when it is not a time of an event, or no run of the combination went on.
    public Optional<KaplanMeier> curve(Combination combination) {
        return sample(combination.number()).curve();
    }

    private Sample sample(int combination) {
        return samples.getOrDefault(combination, new Sample(0, Map.of(), 0, Optional.empty()));
    }
}
