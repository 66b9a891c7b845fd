package rsal.bench.mas;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.junit.jupiter.api.Test;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;

class OverheadBenchTest {
    @Test
    void comparesOurHostWithWhatJavaHas() {
        assertThat(new OverheadBench().names())
                .contains("mas.plain.overhead", "mas.plain.overhead.contracts", "mas.plain.bare.load.cpu");
    }

    @Test
    void measuresWhatIsAskedFor() {
        var results = new ArrayList<Result>();
        new OverheadBench()
                .measure(new BenchmarkRequest(
                        Set.of("mas.plain.bare.create.100"),
                        OptionalInt.of(2),
                        BenchmarkRequest.EPISODES,
                        Optional.empty(),
                        results::add,
                        _ -> {},
                        _ -> {},
                        _ -> {}));
        assertThat(results).singleElement().satisfies(result -> {
            assertThat(result.name()).isEqualTo("mas.plain.bare.create.100");
            assertThat(result.value()).isPositive().isLessThan(10);
        });
    }
}
