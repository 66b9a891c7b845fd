package rsal.bench.python;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.lang.management.ManagementFactory;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.URL;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import rsal.bench.measurement.MeasurementFailed;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// `rsal._bench` in a process of Python: that which `-Drsal.python` or `RSAL_PYTHON` names, else `python3`. It starts
/// RSAL with the options of this JVM.
///
/// @param wanted names of what to measure
/// @param repeats how often
/// @param episodes of the rows that make many
record PythonProgram(List<String> wanted, int repeats, int episodes) {
    private static final JsonMapper MAPPER = new JsonMapper();
    private static final String MAIN = "import sys; sys.path[0] = sys.argv[1]; from rsal._bench import main; main()";

    /// What Python tells of a row.
    ///
    /// @param values none when it is left out
    /// @param note why it is left out
    record Line(String name, double[] values, String note) {
        static Line of(String json) {
            try {
                JsonNode words = MAPPER.readTree(json);
                var values = new ArrayList<Double>();
                words.path("values").forEach(value -> values.add(value.asDouble()));
                return new Line(
                        words.path("name").asString(),
                        values.stream().mapToDouble(Double::doubleValue).toArray(),
                        words.path("note").asString(""));
            } catch (JacksonException e) {
                throw new MeasurementFailed("Python printed '%s', which is no result.".formatted(json));
            }
        }
    }

    /// Measures, and tells each row as soon as it is known.
    ///
    /// @throws MeasurementFailed when there is no Python, or it fails
    void run(Consumer<Line> told) {
        Process process = start();
        try (Writer to = process.outputWriter()) {
            to.write(MAPPER.writeValueAsString(
                    Map.of("wanted", wanted, "repeats", repeats, "episodes", episodes, "command", command())));
        } catch (IOException e) {
            process.destroyForcibly();
            throw new MeasurementFailed("Python ended before it was told what to measure: " + e.getMessage());
        }
        CompletableFuture<String> errors = CompletableFuture.supplyAsync(
                () -> process.errorReader().lines().collect(Collectors.joining("\n")),
                task -> Thread.ofPlatform().daemon().start(task));
        try (BufferedReader lines = process.inputReader()) {
            String line = lines.readLine();
            while (line != null) {
                told.accept(Line.of(line));
                line = lines.readLine();
            }
            if (process.waitFor() != 0) {
                throw new MeasurementFailed("Python failed: " + errors.join());
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Measuring was interrupted.", e);
        } finally {
            process.destroyForcibly(); // when it still runs
        }
    }

    private static Process start() {
        String python = python();
        try {
            return new ProcessBuilder(python, "-X", "utf8", "-c", MAIN, home()).start();
        } catch (IOException e) {
            throw new MeasurementFailed(
                    "Python can't be started: '%s'. Maybe RSAL_PYTHON=/path/to/python3.".formatted(python));
        }
    }

    private static String python() {
        return Optional.ofNullable(System.getProperty("rsal.python"))
                .or(() -> Optional.ofNullable(System.getenv("RSAL_PYTHON")))
                .filter(named -> !named.isBlank())
                .orElse("python3");
    }

    /// What starts RSAL, without a command of it.
    private static List<String> command() {
        var command = new ArrayList<String>();
        command.add(ProcessHandle.current().info().command().orElse("java"));
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), "rsal.cli.Main"));
        return command;
    }

    /// Where Python finds the package `rsal`: a folder, or a place in a jar.
    private static String home() {
        URL marker = Objects.requireNonNull(
                PythonProgram.class.getResource("/rsal/bench/python/home/rsal/_bench.py"),
                "Python's side is beside this class.");
        try {
            if (marker.getProtocol().equals("jar")) {
                String inside = marker.getPath();
                return Path.of(new URI(inside.substring(0, inside.indexOf("!/"))))
                        .resolve("rsal/bench/python/home")
                        .toString();
            }
            return Path.of(marker.toURI()).resolve("../..").normalize().toString();
        } catch (URISyntaxException e) {
            throw new IllegalArgumentException(marker.toString(), e);
        }
    }
}
