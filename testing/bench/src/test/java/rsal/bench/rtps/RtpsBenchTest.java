package rsal.bench.rtps;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.testkit.Rounds;

/// Small forms of the benchmarks, over real sockets. How long anything takes is not looked at.
class RtpsBenchTest {
    private static final LossBench LOSS = new LossBench(2, 10, Duration.ofMillis(10));

    static Stream<Bench> benches() {
        return Stream.of(
                        LOSS,
                        new MapBench(100),
                        new TripBench(50, 20),
                        new DiscoveryBench(3, Duration.ofSeconds(1)),
                        new JoinBench(4, 1))
                .limit(Rounds.of(3, 5));
    }

    private static List<Result> measure(Bench bench) {
        var results = new ArrayList<Result>();
        bench.measure(new BenchmarkRequest(
                Set.copyOf(bench.names()),
                OptionalInt.of(1),
                BenchmarkRequest.EPISODES,
                Optional.empty(),
                results::add,
                _ -> {},
                _ -> {},
                _ -> {}));
        return results;
    }

    @ParameterizedTest
    @MethodSource("benches")
    void measuresAllThatItNamesAndSomeFiguresAreToBeReached(Bench bench) {
        List<Result> results = measure(bench);
        assertThat(results).extracting(Result::name).isEqualTo(bench.names());
        assertThat(results)
                .allSatisfy(result ->
                        assertThat(result.least()).isBetween(result.unit().equals("MB") ? -1e3 : 0, result.most()));
        assertThat(results).anyMatch(result -> result.goal().isPresent());
        assertThat(results)
                .filteredOn(result -> List.of("s", "ms", "us").contains(result.unit()))
                .allMatch(result -> result.value() > 0);
    }

    @Test
    void nothingIsLostForGood() {
        assertThat(measure(LOSS))
                .filteredOn(result -> result.name().endsWith("lost"))
                .singleElement()
                .matches(result -> result.value() == 0);
    }
}
