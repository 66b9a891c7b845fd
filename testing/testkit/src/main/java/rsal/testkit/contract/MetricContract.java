package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.metric.Metric;
import rsal.metric.MetricType;
import rsal.metric.QuantityType;
import rsal.metric.SignalType;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.testkit.fake.FakeRun;

/// What each metric owes to scenarios and runs.
public interface MetricContract {
    /// The metric that is tested.
    MetricType type();

    /// Values for its parameters; the defaults when nothing else is said.
    default Arguments arguments() {
        return Arguments.defaults(type().parameters());
    }

    @Test
    default void metricsSayWhatTheyAre() {
        assertThat(type().key()).isNotBlank();
        assertThat(type().description()).isNotBlank().endsWith(".");
        assertThat(type().parameters()).extracting(Parameter::description).doesNotContain("");
    }

    @Test
    default void metricsOfferSomethingThatIsDescribed() {
        List<String> words = Stream.concat(
                        type().quantities().stream().map(QuantityType::word),
                        type().signals().stream().map(SignalType::word))
                .toList();
        assertThat(words).isNotEmpty().doesNotHaveDuplicates();
        assertThat(type().quantities()).extracting(QuantityType::description).doesNotContain("");
        assertThat(type().signals()).extracting(SignalType::description).doesNotContain("");
    }

    @Test
    default void metricsDoWithoutRobotsAndMessages() {
        var run = new FakeRun();
        Metric metric = type().create(arguments(), run);
        metric.onStep();
        metric.onMessage("operator", "words that no metric knows");
        type().quantities().forEach(quantity -> value(metric, quantity));
        assertThat(run.samples())
                .extracting(FakeRun.Sample::signal)
                .isSubsetOf(type().signals().stream().map(SignalType::word).toList());
    }

    @Test
    default void metricsDoWithRobotsOfWhichNobodyKnowsWhereTheyAre() {
        var run = new FakeRun();
        run.placeNowhere("robot-1", "robot");
        run.place("robot-2", "robot", Pose2d.ORIGIN);
        Metric metric = type().create(arguments(), run);
        metric.onStep();
        run.at(1);
        metric.onStep();
        type().quantities().forEach(quantity -> value(metric, quantity));
    }

    /// A run that is done again gets a metric of its own.
    @Test
    default void metricsOfTwoRunsShareNothing() {
        Metric one = type().create(arguments(), new FakeRun());
        assertThat(type().create(arguments(), new FakeRun())).isNotSameAs(one);
    }

    private static void value(Metric metric, QuantityType quantity) {
        List<String> names =
                quantity.names().stream().map(_ -> "nobody-is-called-so").toList();
        assertThat(metric.value(quantity.word(), names))
                .as(quantity.word())
                .satisfiesAnyOf(
                        value -> assertThat(value).isNaN(),
                        value -> assertThat(value).isFinite());
    }
}
