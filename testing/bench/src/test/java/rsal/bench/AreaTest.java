package rsal.bench;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.function.Consumer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.MeasurementFailed;
import rsal.bench.measurement.Result;

class AreaTest {
    @Test
    void namesAreDottedAndDiffer() {
        assertThat(Area.all().stream().flatMap(area -> area.names().stream()))
                .doesNotHaveDuplicates()
                .allMatch(name -> name.matches("[a-z0-9]+(\\.[A-Za-z0-9]+)+"));
    }

    @Test
    void reportsWhatIsLeftOutForWantOfData(@TempDir Path temp) throws IOException {
        var notes = new ArrayList<String>();
        var assignment = new BenchmarkRequest(
                Set.of("a"),
                OptionalInt.of(1),
                BenchmarkRequest.EPISODES,
                Optional.of(temp),
                _ -> {},
                _ -> {},
                notes::add,
                _ -> {});
        assertThat(assignment.data("logs/some.log")).isEmpty();
        assertThat(notes).singleElement().asString().contains("logs/some.log", "--data");
        Files.createDirectory(temp.resolve("logs"));
        Files.writeString(temp.resolve("logs/some.log"), "");
        assertThat(assignment.data("logs/some.log")).contains(temp.resolve("logs/some.log"));
    }

    @Test
    void theMedianCounts() {
        assertThat(Result.more("a", "s/s", 3, 1, 2))
                .isEqualTo(new Result("a", 2, 1, 3, "s/s", "more", Optional.empty()));
        assertThat(Result.less("a", "B", 4, 1).value()).isEqualTo(2.5);
    }

    private static Bench bench(String name, Consumer<BenchmarkRequest> measure) {
        return new Bench() {
            @Override
            public List<String> names() {
                return List.of(name);
            }

            @Override
            public void measure(BenchmarkRequest assignment) {
                measure.accept(assignment);
            }
        };
    }

    @Test
    void aBenchmarkThatFailsDoesNotEndTheOthers() {
        var results = new ArrayList<Result>();
        Bench fails = bench("a.b", _ -> {
            throw new MeasurementFailed("Within a minute, nothing was found.");
        });
        Bench measures = bench("a.c", assignment -> assignment.report(Result.less("a.c", "s", 1)));
        List<String> failures = new Area("a", List.of(fails, measures))
                .measure(new BenchmarkRequest(
                        Set.of("a.b", "a.c"),
                        OptionalInt.empty(),
                        BenchmarkRequest.EPISODES,
                        Optional.empty(),
                        results::add,
                        _ -> {},
                        _ -> {},
                        _ -> {}));
        assertThat(failures)
                .containsExactly("'a.b' and those after it of the same benchmark were not all measured."
                        + " Within a minute, nothing was found.");
        assertThat(results).extracting(Result::name).containsExactly("a.c");
    }

    @Test
    void whatIsNotWantedIsNotMeasured() {
        var results = new ArrayList<Object>();
        for (Area area : Area.all()) {
            area.measure(new BenchmarkRequest(
                    Set.of(),
                    OptionalInt.of(1),
                    BenchmarkRequest.EPISODES,
                    Optional.empty(),
                    results::add,
                    results::add,
                    results::add,
                    _ -> {}));
        }
        assertThat(results).isEmpty();
    }
}
