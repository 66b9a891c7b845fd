package rsal.testkit;

import static java.nio.file.StandardOpenOption.CREATE;
import static java.nio.file.StandardOpenOption.WRITE;
import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.abort;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;

/// The packages that those publish who make MCAP and its well-known schemas; Cyclone DDS; rosbags, which writes and
/// reads bags of ROS 2; and numpy, which agents in Python need. They are in a Python of their own in the project's
/// `target` folder: made the first time, which
/// needs Python and its registry. Where they can't be had, a test is skipped and says so; in CI it fails. Tests run in
/// several processes: one of them installs, the others wait for it.
public final class OfficialPython {
    private static final List<String> PACKAGES = List.of(
            "mcap==1.6.0",
            "mcap-protobuf-support==0.6.0",
            "foxglove-schemas-protobuf==0.4.0",
            "rosbags==0.11.9",
            "cyclonedds==11.0.1",
            "numpy==2.3.5");
    private static final Path HOME =
            Path.of("..", "..", "target", "official-python").toAbsolutePath().normalize();
    private static final int PATIENCE_SECONDS = 240;

    private OfficialPython() {}

    /// Runs a script.
    ///
    /// @return what it printed
    public static String run(String script, String... arguments) throws IOException, InterruptedException {
        prepare();
        var command = new ArrayList<>(List.of(python().toString(), "-c", script));
        command.addAll(List.of(arguments));
        return ended(command);
    }

    /// The interpreter that has them.
    public static Path interpreter() throws IOException, InterruptedException {
        prepare();
        return python();
    }

    private static Path python() {
        return HOME.resolve("bin").resolve("python");
    }

    private static void prepare() throws IOException, InterruptedException {
        Path done = HOME.resolve("done-2");
        if (Files.exists(done)) {
            return;
        }
        Files.createDirectories(HOME);
        try (var turn = FileChannel.open(HOME.resolve("lock"), CREATE, WRITE)) {
            turn.lock(); // until it is closed
            if (Files.exists(done)) {
                return;
            }
            ended(List.of("python3", "-m", "venv", HOME.toString()));
            var install =
                    new ArrayList<>(List.of(python().toString(), "-m", "pip", "install", "--quiet", "--no-compile"));
            install.addAll(PACKAGES);
            ended(install);
            Files.createFile(done);
        } catch (IOException | AssertionError e) {
            if (System.getenv("CI") != null) {
                throw e;
            }
            abort("SKIPPED, NOT CHECKED by the official Python package: it can't be had here (%s)."
                    .formatted(e.getMessage()));
        }
    }

    private static String ended(List<String> command) throws IOException, InterruptedException {
        Path out = Files.createTempFile("python", ".out");
        try {
            var builder = new ProcessBuilder(command).redirectErrorStream(true).redirectOutput(out.toFile());
            builder.environment().putAll(Map.of("PYTHONUTF8", "1"));
            Process process = builder.start();
            boolean ended = process.waitFor(PATIENCE_SECONDS, TimeUnit.SECONDS);
            process.destroyForcibly();
            String printed = Files.readString(out, StandardCharsets.UTF_8);
            assertThat(ended && process.exitValue() == 0)
                    .as("%s: %s", String.join(" ", command.subList(0, 2)), printed)
                    .isTrue();
            return printed;
        } finally {
            Files.delete(out);
        }
    }
}
