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
    private static final int TIME_IS_UP = 1; // before what the scenario wants

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
    /// @throws IllegalStateException when it could not run
    static WholeRun of(String subject, Duration simulated) {
        try {
            long start = System.nanoTime();
            Process process = new ProcessBuilder(command(subject, simulated))
                    .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                    .start();
            var printed = CompletableFuture.supplyAsync(
                    () -> Printed.of(process),
                    task -> Thread.ofPlatform().daemon().start(task));
            Duration cpu = Duration.ZERO;
            while (!process.waitFor(LOOK_MILLIS, TimeUnit.MILLISECONDS)) {
                cpu = process.info().totalCpuDuration().orElse(cpu);
            }
            long end = System.nanoTime();
            if (process.exitValue() != SUCCESS && process.exitValue() != TIME_IS_UP) {
                throw new IllegalStateException("A run of '%s' failed with exit code %d: %s"
                        .formatted(subject, process.exitValue(), printed.join().text()));
            }
            return new WholeRun(
                    (end - start) * 1e-9, cpu.toNanos() * 1e-9, (printed.join().began() - start) * 1e-9);
        } catch (IOException e) {
            throw new UncheckedIOException("A run can't be started.", e);
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
            throw new IllegalStateException("Measuring was interrupted.", e);
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
