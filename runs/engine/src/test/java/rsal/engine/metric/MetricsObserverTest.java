package rsal.engine.metric;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.file.Path;
import java.util.OptionalDouble;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.Runs;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.settings.InvalidSettings;

/// What a scenario measures of distances, places, messages, and values that its own agents publish.
class MetricsObserverTest {
    private static final String SCENARIO = """
            rsal: 1
            scenario: metrics
            world: {map: office}
            robots:
              post: {model: pioneer2dx, pose: [-12, -1, 0]}
              cart: {model: pioneer2dx, count: 2, pose: [[-9, -1, 0], [-8, -1, 0]]}
            agents:
              load: {type: load.asl, robot: cart}
              drive: {type: drive.asl}
            places:
              start: {at: [-9, -1], radius: 0.5}
              west: {within: [-20, -3, -10.5, 3]}
            mas: {use: jason}
            run:
              clock: {speed: max}
              stop: [{when: time >= 10, outcome: success}]
            metrics:
              - {name: near, from: 'min(distance(cart, post))'}
              - {name: inStart, from: 'mean(within(cart, start))'}
              - {name: came, from: 'last(visits(cart, start))'}
              - {name: said, from: 'count(sentMessages(speech))'}
              - {name: all, from: count(sentMessages)}
              - {name: last, from: last(metric(load))}
              - {name: mean, from: mean(metric(load))}
              - {name: weighted, from: timeWeightedMean(metric(load)), per: robot}
              - {name: high, from: firstTime(metric(load) > 3)}
              - {name: never, from: max(metric(nothing))}
            """;

    @TempDir
    private Path folder;

    @Test
    void ofAWholeRun() {
        Runs.write(folder.resolve("load.asl"), """
                !begin.
                +!begin <- .metric(load, 2); .wait(2000); .metric(load, 4); .wait(1000); .metric(load, 0).
                """);
        Runs.write(
                folder.resolve("drive.asl"),
                "!begin. +!begin <- .broadcast(tell, hello); .wait(2000); .broadcast(tell, hello).");
        var plan = Runs.plan(folder, SCENARIO, RunOptions.NONE);
        RunResult result = Runs.result(plan);
        assertThat(value(result, "near")).isCloseTo(3, within(0.01));
        assertThat(value(result, "inStart")).isEqualTo(1);
        assertThat(value(result, "came")).isZero();
        assertThat(value(result, "said")).isEqualTo(2);
        assertThat(value(result, "all")).isEqualTo(2);
        assertThat(value(result, "last")).isZero();
        assertThat(value(result, "mean")).isEqualTo(2);
        assertThat(value(result, "weighted.cart-1")).isCloseTo(0.8, within(0.1));
        assertThat(value(result, "weighted.cart-2")).isCloseTo(0.8, within(0.1));
        assertThat(result.metrics()).containsEntry("weighted.post", OptionalDouble.empty());
        assertThat(value(result, "high")).isCloseTo(2, within(0.3));
        assertThat(result.metrics()).containsEntry("never", OptionalDouble.empty());
        assertThat(Runs.result(plan).eventHash()).isEqualTo(result.eventHash());
    }

    @Test
    void namesThatAreNoPlacesAreRefused() {
        Runs.write(folder.resolve("load.asl"), "");
        Runs.write(folder.resolve("drive.asl"), "");
        assertThatThrownBy(() -> Runs.plan(
                        folder, SCENARIO.replace("visits(cart, start)", "visits(cart, strat)"), RunOptions.NONE))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining("No place is called 'strat'")
                .hasMessageContaining("start");
        assertThatThrownBy(() ->
                        Runs.plan(folder, SCENARIO.replace("radius: 0.5", "within: [0, 0, 1, 1]"), RunOptions.NONE))
                .hasMessageContaining("has both 'at' and 'within'");
        assertThatThrownBy(() -> Runs.plan(
                        folder, SCENARIO.replace("at: [-9, -1], radius: 0.5", "radius: 0.5"), RunOptions.NONE))
                .hasMessageContaining("needs 'at' or 'within'");
        assertThatThrownBy(() -> Runs.plan(folder, SCENARIO.replace("-10.5, 3]", "-30, 3]"), RunOptions.NONE))
                .hasMessageContaining("'within' must be [least x, least y, greatest x, greatest y]");
    }

    private static double value(RunResult result, String metric) {
        return result.metrics().get(metric).orElseThrow();
    }
}
