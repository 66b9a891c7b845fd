package rsal.bench.robots;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.management.ManagementFactory;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.function.Supplier;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import rsal.time.AllowedToReadWallClock;

/// A run as people start it: a process of its own from `rsal run … --headless --speed max`, with the options of this
/// one's JVM, from its start until it has ended.
///
/// @param wall real time [s]
/// @param cpu time of all processors [s]; looked at every [#LOOK_MILLIS] until the end, so up to that much less
/// @param firstLine real time until it printed its first line [s]
@AllowedToReadWallClock("Benchmarks measure real time.")
record WholeRun(double wall, double cpu, double firstLine) {
    private static final long LOOK_MILLIS = 5;
    private static final int SUCCESS = 0;
    private static final Pattern SIMULATED = Pattern.compile("([0-9.]+) s simulated");
    private static final double ROUNDED = 0.1; // s, in what a run prints

    /// What it printed, and when it began to [ns].
    private record Printed(String text, long began) {
        static Printed of(Process process) {
            try (BufferedReader lines = process.errorReader()) {
                String first = String.valueOf(lines.readLine());
                long began = System.nanoTime();
                return new Printed(first + "\n" + lines.lines().collect(Collectors.joining("\n")), began);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
    }

    /// Makes a run, and waits for its end.
    ///
    /// @param subject a scenario, or the file of a world
    /// @param simulated how long it is, of its own time
    /// @throws IllegalStateException when it could not run, or ended before that
    static WholeRun of(String subject, Duration simulated) {
        Process process;
        long start = System.nanoTime();
        try {
            process = new ProcessBuilder(command(subject, simulated)).start();
        } catch (IOException e) {
            throw new UncheckedIOException("A run can't be started.", e);
        }
        try {
            return measured(process, start, subject, simulated);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Measuring was interrupted.", e);
        } finally {
            process.destroyForcibly(); // when it still runs
        }
    }

    private static WholeRun measured(Process process, long start, String subject, Duration simulated)
            throws InterruptedException {
        var printed = apart(() -> Printed.of(process));
        var result = apart(() -> process.inputReader().lines().collect(Collectors.joining("\n")));
        Duration cpu = Duration.ZERO;
        while (!process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
            cpu = process.info().totalCpuDuration().orElse(cpu);
        }
        long end = System.nanoTime();
        if (process.exitValue() != SUCCESS) {
            throw new IllegalStateException("A run of '%s' failed with exit code %d: %s"
                    .formatted(subject, process.exitValue(), printed.join().text()));
        }
        checkLength(subject, simulated.toMillis() * 1e-3, result.join());
        return new WholeRun(
                (end - start) * 1e-9, cpu.toNanos() * 1e-9, (printed.join().began() - start) * 1e-9);
    }

    private static <T> CompletableFuture<T> apart(Supplier<T> work) {
        return CompletableFuture.supplyAsync(
                work, task -> Thread.ofPlatform().daemon().start(task));
    }

    /// A run that reached its goal early would count as a faster one.
    ///
    /// @param seconds how long it should have been [s]
    /// @param result as it printed it
    static void checkLength(String subject, double seconds, String result) {
        Matcher simulated = SIMULATED.matcher(result);
        if (!simulated.find() || Double.parseDouble(simulated.group(1)) < seconds - ROUNDED) {
            throw new IllegalStateException(
                    "A run of '%s' did not last for '%s' s: '%s'. Choose a scenario that does not end by itself."
                            .formatted(subject, seconds, result.strip()));
        }
    }

    private static List<String> command(String subject, Duration simulated) {
        var command = new ArrayList<String>();
        command.add(ProcessHandle.current().info().command().orElse("java"));
        command.addAll(ManagementFactory.getRuntimeMXBean().getInputArguments());
        command.addAll(List.of("-cp", System.getProperty("java.class.path"), program()));
        command.addAll(List.of("run", subject, "--headless", "--speed", "max", "--seed", "1"));
        command.addAll(List.of("--for", String.valueOf(simulated.toMillis() * 1e-3)));
        return command;
    }

    /// The class that was started to get here: that of the command line.
    private static String program() {
        return System.getProperty("sun.java.command", "rsal.cli.Main").split(" ", 2)[0];
    }
}
