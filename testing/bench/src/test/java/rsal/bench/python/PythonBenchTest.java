package rsal.bench.python;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.MeasurementFailed;
import rsal.bench.measurement.Result;

class PythonBenchTest {
    private static BenchmarkRequest request(Set<String> wanted, List<Result> results) {
        return new BenchmarkRequest(
                wanted,
                OptionalInt.of(2),
                BenchmarkRequest.EPISODES,
                Optional.empty(),
                results::add,
                _ -> {},
                _ -> {},
                _ -> {});
    }

    /// Python knows the end of each name; the beginning may be of several.
    @Test
    void eachRowIsMeasuredInPython() throws IOException {
        try (InputStream program = PythonBench.class.getResourceAsStream("/rsal/bench/python/home/rsal/_bench.py")) {
            assertThat(program).isNotNull();
            String text = new String(program.readAllBytes(), StandardCharsets.UTF_8);
            assertThat(new PythonBench().names()).allSatisfy(name -> {
                boolean isWhole = text.contains("\"" + name + "\"");
                String last = name.replaceFirst("python\\.env\\.episodes\\.", "");
                assertThat(isWhole || text.contains("\"" + last + "\""))
                        .as(name)
                        .isTrue();
            });
        }
    }

    @Test
    void thePackageOfPythonIsWhole() throws IOException {
        Path sources = Path.of("../../clients/python/src/rsal");
        try (Stream<Path> files = Files.walk(sources)) {
            assertThat(files.filter(Files::isRegularFile)
                            .filter(file -> !file.toString().contains("__pycache__")))
                    .isNotEmpty()
                    .allSatisfy(file -> assertThat(PythonBench.class.getResource(
                                    "/rsal/bench/python/home/rsal/" + sources.relativize(file)))
                            .as(file.toString())
                            .isNotNull());
        }
    }

    @Test
    void linesAreResultsOrSayWhyThereIsNone() {
        assertThat(PythonProgram.Line.of("{\"name\": \"a.b\", \"values\": [1, 2.5]}")
                        .values())
                .containsExactly(1, 2.5);
        assertThat(PythonProgram.Line.of("{\"name\": \"a.b\", \"note\": \"not installed\"}"))
                .satisfies(line -> assertThat(line.values()).isEmpty())
                .satisfies(line -> assertThat(line.note()).isEqualTo("not installed"));
        assertThatThrownBy(() -> PythonProgram.Line.of("Traceback"))
                .isInstanceOf(MeasurementFailed.class)
                .hasMessageContaining("Traceback");
    }

    @Test
    void theImportIsMeasured() {
        assumeTrue(isThere("python3"), "There is no Python.");
        var results = new ArrayList<Result>();
        new PythonBench().measure(request(Set.of("python.import.ms"), results));
        assertThat(results).singleElement().satisfies(result -> {
            assertThat(result.name()).isEqualTo("python.import.ms");
            assertThat(result.least()).isPositive();
            assertThat(result.goal()).contains(50.0);
        });
    }

    private static boolean isThere(String program) {
        return Stream.of(System.getenv("PATH").split(":")).anyMatch(folder -> {
            return Files.isExecutable(Path.of(folder, program));
        });
    }
}
