package rsal.bench.scenario;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;

class SeededRunsIT {
    private final List<Result> results = new ArrayList<>();
    private final List<String> progress = new ArrayList<>();

    private BenchmarkRequest assignment(List<String> wanted, int seeds) {
        return new BenchmarkRequest(
                Set.copyOf(wanted),
                OptionalInt.of(seeds),
                BenchmarkRequest.EPISODES,
                Optional.empty(),
                results::add,
                _ -> {},
                _ -> {},
                progress::add);
    }

    @Test
    void runsHaveTheSeedsFromOneOnAndAreTheSameAgain() {
        Scenario scenario = Scenario.load("hunt-and-prey");
        var options = RunOptions.NONE.withLimit(Duration.ofSeconds(5));
        List<RunResult> three = SeededRuns.of("hunt", scenario, options, assignment(List.of(), 3));
        assertThat(three).extracting(RunResult::seed).containsExactly(1L, 2L, 3L);
        assertThat(three).extracting(RunResult::eventHash).doesNotHaveDuplicates();
        assertThat(progress).first().isEqualTo("hunt.runs: 0 of 3");
        assertThat(progress).last().isEqualTo("hunt.runs: 3 of 3");
        assertThat(SeededRuns.of("hunt", scenario, options, assignment(List.of(), 2)))
                .extracting(RunResult::eventHash)
                .isEqualTo(three.stream().limit(2).map(RunResult::eventHash).toList());
        assertThat(SeededRuns.values(three, "captureTime", RunResult::simulatedSeconds))
                .containsOnly(5);
    }

    @Test
    @LongTest
    void huntersThatBidAreComparedWithThoseThatDoNot() {
        var bench = new HuntBench();
        bench.measure(assignment(bench.names(), 2));
        assertThat(results).extracting(Result::name).containsExactlyInAnyOrderElementsOf(bench.names());
        assertThat(value("hunt.bids.sooner"))
                .isNotZero()
                .isEqualTo(value("hunt.fixed.seconds") - value("hunt.bids.seconds"), within(1e-9));
        assertThat(value("hunt.bids.caught")).isEqualTo(1);
        assertThat(progress).contains("hunt.bids.runs: 2 of 2", "hunt.fixed.runs: 2 of 2");
    }

    private double value(String name) {
        return results.stream()
                .filter(result -> result.name().equals(name))
                .findFirst()
                .orElseThrow()
                .value();
    }
}
