package rsal.cli.grade;

import java.io.IOException;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.stream.Collectors;
import rsal.cli.terminal.Exit;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.json.JsonMapper;

/// Runs a scenario in processes of their own, each with bounded time and memory. This is a guard against errors, as
/// an endless loop, and no sandbox: agents in Java may do all that the person may who starts them.
///
/// @param java the command that starts RSAL, with its bound of memory
/// @param folder where the scenario is, and where processes are started
/// @param scenario as `rsal run` takes it
/// @param logs a folder for `seed-N.log`: what each run told on stderr
/// @param longest wall time of a run
/// @param options of `rsal run`
record SeparateRun(List<String> java, Path folder, String scenario, Path logs, Duration longest, List<String> options) {
    private static final int MOST_OUTPUT = 1 << 20; // bytes kept of what a process prints, the last ones
    private static final String LACK_OF_MEMORY =
            "of memory that it may have are not enough"; // as rsal.cli.Main tells it
    private static final String NO_RESULT = "It printed no result.";
    private static final int MOST_MESSAGE = 300;
    private static final Set<Process> RUNNING = ConcurrentHashMap.newKeySet();

    /// How a run ended.
    ///
    /// @param outcome of the scenario (`success`, `failure`, `timeout`, `limit`), or `invalid`, `broken`,
    ///         `time limit`, `memory limit`
    /// @param success whether the run ended in success, and no agent by an error
    /// @param metrics by name, without those that had nothing to measure
    /// @param message empty when there is nothing to say
    record Result(
            long seed,
            String outcome,
            boolean success,
            double simulatedSeconds,
            String eventHash,
            Map<String, Double> metrics,
            String message) {
        static Result failed(long seed, String outcome, String message) {
            return new Result(seed, outcome, false, 0, "", Map.of(), shortened(message));
        }

        /// The same of another seed, as of what can't be read whatever the seed is.
        Result with(long other) {
            return new Result(other, outcome, success, simulatedSeconds, eventHash, metrics, message);
        }

        boolean isInvalid() {
            return outcome.equals("invalid");
        }
    }

    /// Ends all that are running, as when a signal ends this process.
    static void endAll() {
        RUNNING.forEach(SeparateRun::end);
    }

    /// Runs once, and waits for the end.
    ///
    /// @throws IOException if Java can't be started, or the log can't be written
    Result run(long seed) throws IOException, InterruptedException {
        var command = new ArrayList<>(java);
        command.addAll(
                List.of("run", scenario, "--headless", "--speed", "max", "--seed", Long.toString(seed), "--json"));
        command.addAll(options);
        Process process = new ProcessBuilder(command).directory(folder.toFile()).start();
        RUNNING.add(process);
        try {
            process.getOutputStream().close();
            FutureTask<String> out = reading(process.getInputStream());
            FutureTask<String> err = reading(process.getErrorStream());
            boolean ended = process.waitFor(longest.toMillis(), TimeUnit.MILLISECONDS);
            end(process);
            String reported = text(err);
            Files.createDirectories(logs);
            Files.writeString(logs.resolve("seed-%d.log".formatted(seed)), reported);
            return ended
                    ? result(seed, process.exitValue(), text(out), reported)
                    : Result.failed(seed, "time limit", "It did not end within %d s.".formatted(longest.toSeconds()));
        } finally {
            end(process);
            RUNNING.remove(process);
        }
    }

    /// To destroy one that has ended would close what it printed.
    private static void end(Process process) {
        process.descendants().forEach(ProcessHandle::destroyForcibly);
        if (process.isAlive()) {
            process.destroyForcibly();
        }
    }

    private static String text(FutureTask<String> read) throws InterruptedException {
        try {
            return read.get();
        } catch (ExecutionException e) {
            return "";
        }
    }

    private static FutureTask<String> reading(InputStream stream) {
        var task = new FutureTask<>(() -> lastOf(stream));
        Thread.ofVirtual().start(task);
        return task;
    }

    /// Reads to the end, and keeps the last part.
    private static String lastOf(InputStream stream) {
        byte[] kept = new byte[0];
        byte[] buffer = new byte[1 << 14];
        try (stream) {
            for (int read = stream.read(buffer); read >= 0; read = stream.read(buffer)) {
                int from = Math.max(0, kept.length + read - MOST_OUTPUT);
                byte[] longer = new byte[kept.length - from + read];
                System.arraycopy(kept, from, longer, 0, kept.length - from);
                System.arraycopy(buffer, 0, longer, kept.length - from, read);
                kept = longer;
            }
        } catch (IOException e) {
            // the process was ended
        }
        return new String(kept, StandardCharsets.UTF_8);
    }

    private static Result result(long seed, int code, String out, String err) {
        if (code == Exit.SUCCESS || code == Exit.NO_SUCCESS) {
            String line = out.lines().filter(each -> each.startsWith("{")).reduce("", (_, last) -> last);
            try {
                JsonNode result = JsonMapper.shared().readTree(line);
                return result.isObject() ? result(seed, code, result) : Result.failed(seed, "broken", NO_RESULT);
            } catch (JacksonException e) {
                return Result.failed(seed, "broken", NO_RESULT);
            }
        }
        String message = err.lines().filter(line -> !line.isBlank()).limit(3).collect(Collectors.joining(" "));
        return switch (code) {
            case Exit.INVALID -> Result.failed(seed, "invalid", message);
            case Exit.UNREACHABLE ->
                err.contains(LACK_OF_MEMORY)
                        ? Result.failed(seed, "memory limit", "It needs more memory than it may have (--memory).")
                        : Result.failed(seed, "broken", lastLine(err));
            default -> Result.failed(seed, "broken", lastLine(err));
        };
    }

    private static Result result(long seed, int code, JsonNode result) {
        var metrics = new LinkedHashMap<String, Double>();
        result.path("metrics").properties().stream()
                .filter(metric -> metric.getValue().isNumber())
                .forEach(
                        metric -> metrics.put(metric.getKey(), metric.getValue().asDouble()));
        String outcome = result.path("outcome").asString("broken");
        String failed = result.path("failed").properties().stream()
                .map(agent -> "%s failed: %s"
                        .formatted(agent.getKey(), agent.getValue().asString("")))
                .collect(Collectors.joining("; "));
        String message = failed.isEmpty() && outcome.equals("limit") ? "--for ended it before its own end." : failed;
        return new Result(
                seed,
                outcome,
                code == Exit.SUCCESS && outcome.equals("success"),
                result.path("simulatedSeconds").asDouble(0),
                result.path("eventHash").asString(""),
                metrics,
                shortened(message));
    }

    private static String lastLine(String text) {
        return text.lines()
                .filter(line -> !line.isBlank())
                .reduce("", (_, last) -> last)
                .strip()
                .replaceFirst("^rsal: ", "");
    }

    private static String shortened(String message) {
        String line = message.strip().replaceAll("\\s+", " ");
        return line.length() <= MOST_MESSAGE ? line : line.substring(0, MOST_MESSAGE - 1) + "…";
    }
}
