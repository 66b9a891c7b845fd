package rsal.bench.robots;

import java.io.BufferedReader;
import java.io.BufferedWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.jspecify.annotations.Nullable;

/// [Beacons] as who started it sees it.
final class BeaconProcess implements AutoCloseable {
    private final Process process;
    private final BufferedReader said;
    private final BufferedWriter asked;
    private final List<Integer> ports;

    /// Starts it, and waits until its robots can be reached.
    ///
    /// @param bridge over which it offers them
    /// @param port where that begins; 0 for any
    BeaconProcess(String bridge, int port, Beacon.Kind kind, int robots) {
        try {
            process = new ProcessBuilder(
                            ProcessHandle.current().info().command().orElse("java"),
                            "-cp",
                            System.getProperty("java.class.path"),
                            Beacons.class.getName(),
                            bridge,
                            String.valueOf(port),
                            kind.name(),
                            String.valueOf(robots))
                    .redirectError(ProcessBuilder.Redirect.INHERIT)
                    .start();
        } catch (IOException e) {
            throw new UncheckedIOException("The process of the robots can't be started.", e);
        }
        said = process.inputReader();
        asked = process.outputWriter();
        ports = numbers();
    }

    /// Where its robots are, in their order.
    List<Integer> ports() {
        return ports;
    }

    /// Has its robots tell no more.
    ///
    /// @return the number of each one's last readings
    List<Integer> quiet() {
        ask();
        return numbers();
    }

    private void ask() {
        try {
            asked.newLine();
            asked.flush();
        } catch (IOException e) {
            throw new UncheckedIOException("The process of the robots has ended.", e);
        }
    }

    private List<Integer> numbers() {
        try {
            @Nullable String line = said.readLine();
            if (line == null) {
                throw new IOException("The process of the robots has ended.");
            }
            return Arrays.stream(line.split(" ", -1)).map(Integer::valueOf).toList();
        } catch (IOException e) {
            process.destroyForcibly();
            throw new UncheckedIOException(e);
        }
    }

    /// Ends it, and waits for that.
    @Override
    public void close() {
        process.destroy();
        try {
            if (!process.waitFor(5, TimeUnit.SECONDS)) {
                process.destroyForcibly();
            }
        } catch (InterruptedException e) {
            process.destroyForcibly();
            Thread.currentThread().interrupt();
        }
    }
}
