package rsal.experiment.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.experiment.Change;
import rsal.experiment.Combination;
import rsal.experiment.Findings;
import rsal.experiment.Findings.Interaction;
import rsal.experiment.Manifest.MetricEntry;
import rsal.experiment.MetricSamples;
import rsal.experiment.statistics.ConfidenceInterval;
import rsal.experiment.statistics.Effect;
import rsal.experiment.statistics.Mean;

/// What an experiment says: all that is compared, and which differences are clear. p-values are corrected within each
/// table of the report: the changes of one metric, its interactions, the changes of all outcomes.
public final class Conclusions {
    private final List<Compared<Ending>> endings;
    private final List<Quantity> quantities;

    /// How often runs end in some way.
    record Ending(String outcome, Change change) {
        @Override
        public String toString() {
            return change.toString();
        }
    }

    /// One metric.
    record Quantity(MetricSamples measurements, List<Compared<Change>> changes, List<InPlaces> interactions) {
        MetricEntry metric() {
            return measurements.metric();
        }
    }

    /// What a change does depends on another one.
    ///
    /// @param before what the first does before the other
    /// @param after what it does after it
    record InPlaces(Compared<Interaction> compared, Effect before, Effect after) {}

    /// A difference in words.
    ///
    /// @param subject `hunters 2 → 3`
    /// @param said what it does
    public record Sentence(String subject, String said) {
        @Override
        public String toString() {
            return subject + said;
        }
    }

    private Conclusions(List<Compared<Ending>> endings, List<Quantity> quantities) {
        this.endings = endings;
        this.quantities = quantities;
    }

    public static Conclusions of(Findings findings) {
        List<Change> changes = findings.changes();
        List<Ending> endings = reportedApart(Figures.outcomes(findings)).stream()
                .flatMap(outcome -> changes.stream().map(change -> new Ending(outcome, change)))
                .toList();
        return new Conclusions(
                Compared.together(endings, ending -> findings.effectOnShare(ending.change(), ending.outcome())),
                findings.manifest().metrics().stream()
                        .map(metric -> quantity(findings, metric))
                        .toList());
    }

    /// The outcomes whose shares tell something by themselves: of two, one is what the other isn't.
    private static List<String> reportedApart(List<String> outcomes) {
        return outcomes.size() <= 2 ? outcomes.subList(0, outcomes.size() / 2) : outcomes;
    }

    private static Quantity quantity(Findings findings, MetricEntry metric) {
        MetricSamples measurements = findings.measurements(metric);
        List<Compared<Interaction>> interactions =
                Compared.together(findings.interactions(), each -> findings.effect(each, measurements));
        return new Quantity(
                measurements,
                Compared.together(findings.changes(), change -> findings.effect(change, measurements)),
                interactions.stream()
                        .map(each -> new InPlaces(
                                each,
                                where(
                                        findings,
                                        each.subject(),
                                        each.subject().where().from(),
                                        measurements),
                                where(
                                        findings,
                                        each.subject(),
                                        each.subject().where().to(),
                                        measurements)))
                        .toList());
    }

    private static Effect where(Findings findings, Interaction interaction, String level, MetricSamples measurements) {
        return findings.effectWhere(interaction.change(), interaction.where().factor(), level, measurements);
    }

    List<Compared<Ending>> endings() {
        return endings;
    }

    List<Quantity> quantities() {
        return quantities;
    }

    /// How many comparisons there are of which something is known.
    public int known() {
        return (int) Stream.concat(endings.stream(), quantities.stream().flatMap(Conclusions::all))
                .filter(Compared::isKnown)
                .count();
    }

    private static Stream<Compared<?>> all(Quantity quantity) {
        return Stream.concat(
                quantity.changes().stream(), quantity.interactions().stream().map(InPlaces::compared));
    }

    /// The clear differences.
    public List<Sentence> clear() {
        return sentences(true);
    }

    /// Those of which nobody can say that there is a difference.
    public List<Sentence> unclear() {
        return sentences(false);
    }

    private List<Sentence> sentences(boolean clear) {
        var sentences = new ArrayList<Sentence>();
        endings.stream()
                .filter(each -> each.isKnown() && each.isClear() == clear)
                .forEach(each -> sentences.add(sentence(
                        each,
                        " percentage points of runs that end as "
                                + each.subject().outcome(),
                        "")));
        for (Quantity quantity : quantities) {
            MetricEntry metric = quantity.metric();
            quantity.changes().stream()
                    .filter(each -> each.isKnown() && each.isClear() == clear)
                    .forEach(each -> sentences.add(sentence(
                            each,
                            unit(metric) + " of " + metric.name(),
                            clear ? judged(metric, each.difference()) : "")));
            quantity.interactions().stream()
                    .filter(each -> each.compared().isKnown() && each.compared().isClear() == clear)
                    .forEach(each -> sentences.add(sentence(metric, each)));
        }
        return List.copyOf(sentences);
    }

    private static Sentence sentence(Compared<?> compared, String what, String judged) {
        return new Sentence(
                String.valueOf(compared.subject()),
                ": %s%s (%s)%s".formatted(NumberFormats.signed(compared.difference()), what, sure(compared), judged));
    }

    private static Sentence sentence(MetricEntry metric, InPlaces places) {
        Interaction interaction = places.compared().subject();
        Change where = interaction.where();
        String factor = where.factor().argument();
        return new Sentence(
                interaction.change().toString(),
                ": what it does to %s depends on %s: %s%s where it is %s, %s%s where it is %s (difference %s, %s)"
                        .formatted(
                                metric.name(),
                                factor,
                                difference(places.before()),
                                unit(metric),
                                where.from(),
                                difference(places.after()),
                                unit(metric),
                                where.to(),
                                NumberFormats.signed(places.compared().difference()),
                                sure(places.compared())));
    }

    private static String difference(Effect effect) {
        return effect.difference()
                .map(mean -> NumberFormats.signed(mean.value()))
                .orElse("–");
    }

    /// `95 % −30 to −14, 30 of 30 seeds, p = 0.012`
    private static String sure(Compared<?> compared) {
        Optional<ConfidenceInterval> interval = compared.effect().difference().flatMap(Mean::interval);
        String p = NumberFormats.probability(compared.corrected().orElseThrow());
        return "95 %% %s, %d of %d seeds, p %s"
                .formatted(
                        interval.map(NumberFormats::signed).orElse("–"),
                        compared.effect().complete(),
                        compared.effect().blocks(),
                        p.startsWith("<") ? p : "= " + p);
    }

    private static String judged(MetricEntry metric, double difference) {
        return switch (metric.better()) {
            case "less" -> difference < 0 ? ": better" : ": worse";
            case "more" -> difference > 0 ? ": better" : ": worse";
            default -> "";
        };
    }

    private static String unit(MetricEntry metric) {
        return metric.unit().isEmpty() ? "" : " " + metric.unit();
    }

    /// What is to be known of runs that have no value, a sentence for each metric in which there are some.
    ///
    /// @param combinations of which runs have ended
    public List<String> missing(List<Combination> combinations) {
        return quantities.stream()
                .map(Quantity::measurements)
                .map(measurements -> missing(measurements, combinations))
                .flatMap(Optional::stream)
                .toList();
    }

    static Optional<String> missing(MetricSamples measurements, List<Combination> combinations) {
        int runs = combinations.stream().mapToInt(measurements::runs).sum();
        int used = combinations.stream().mapToInt(measurements::used).sum();
        int without =
                runs - combinations.stream().mapToInt(measurements::reached).sum();
        String name = measurements.metric().name();
        if (without == 0) {
            return Optional.empty();
        }
        if (measurements.horizon().isPresent()) {
            String left = used < runs ? " %d runs broke and are not counted.".formatted(runs - used) : "";
            return Optional.of(
                    "%s: in %d of %d runs it did not happen. Such a run counts with the time until its end, at most %s%s. So no seed is left out.%s"
                            .formatted(
                                    name,
                                    without - (runs - used),
                                    runs,
                                    NumberFormats.of(measurements.horizon().getAsDouble()),
                                    unit(measurements.metric()),
                                    left));
        }
        return Optional.of(
                "%s: %d of %d runs have no value and are not counted. If they have none because they failed, the mean is too good. So first compare how the runs ended."
                        .formatted(name, without, runs));
    }
}
