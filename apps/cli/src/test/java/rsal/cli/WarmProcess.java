package rsal.cli;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.ProcessBuilder.Redirect;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.extension.AnnotatedElementContext;
import org.junit.jupiter.api.extension.ExtensionContext;
import org.junit.jupiter.api.io.TempDirFactory;

/// A process that does one command line after the other, in a folder of its own: a start takes most of the time that
/// a short command needs. Tests whose commands name files in their folder take that folder as theirs:
///
/// ```java
/// @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
/// Path folder;
/// ```
///
/// What is told by signals, variables of the environment, or flags of the JVM is tried by processes as before.
final class WarmProcess {
    /// Names the folder where pages leave what operators need.
    static final String RUNTIME = "XDG_RUNTIME_DIR";

    private static final Path FOLDER = make();
    private static final int PATIENCE_SECONDS = 120; // as for a process of its own, which has 60 and waits for nobody
    private static Optional<WarmProcess> running = Optional.empty(); // guarded by the class

    private final Process process;
    private final DataOutputStream to;
    private final DataInputStream from;

    private WarmProcess(Process process) {
        this.process = process;
        to = new DataOutputStream(process.getOutputStream());
        from = new DataInputStream(process.getInputStream());
    }

    /// Whether it is at work there.
    static boolean isIn(Path folder) {
        return folder.equals(FOLDER);
    }

    /// One command line after the other. After one that hangs or ends the process, the next has a new one.
    static synchronized Ended run(String... arguments) throws IOException {
        WarmProcess warm = running.orElseGet(WarmProcess::start);
        running = Optional.of(warm);
        CompletableFuture<Boolean> isDone = new CompletableFuture<>();
        var _ = isDone.completeOnTimeout(false, PATIENCE_SECONDS, TimeUnit.SECONDS)
                .thenAccept(done -> {
                    if (!done) {
                        warm.process.destroyForcibly(); // which ends the reading
                    }
                });
        try {
            return warm.execute(arguments);
        } catch (IOException e) {
            running = Optional.empty();
            throw new IOException(
                    "'rsal %s' ended its process, or took more than %d s."
                            .formatted(String.join(" ", arguments), PATIENCE_SECONDS),
                    e);
        } finally {
            isDone.complete(true);
        }
    }

    private Ended execute(String... arguments) throws IOException {
        to.writeInt(arguments.length);
        for (String argument : arguments) {
            WarmMain.write(to, argument.getBytes(StandardCharsets.UTF_8));
        }
        to.flush();
        return new Ended(from.readInt(), WarmMain.read(from), WarmMain.read(from));
    }

    private static Path make() {
        try {
            return Files.createTempDirectory("rsal-tests").toRealPath();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static WarmProcess start() {
        try {
            var builder = new ProcessBuilder(new Rsal(FOLDER, ownClasses()).javaCommand(WarmMain.class.getName()))
                    .directory(FOLDER.toFile())
                    .redirectError(Redirect.INHERIT);
            builder.environment().remove("NO_COLOR");
            builder.environment().put(RUNTIME, FOLDER.toString());
            Process process = builder.start();
            Runtime.getRuntime().addShutdownHook(new Thread(() -> end(process)));
            return new WarmProcess(process);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static void end(Process process) {
        try {
            process.getOutputStream().close(); // so that it ends by itself
            if (!process.waitFor(Duration.ofSeconds(5))) {
                process.destroyForcibly();
            }
            if (Files.exists(FOLDER)) { // unless another one has ended
                empty(FOLDER);
                Files.delete(FOLDER);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        } catch (InterruptedException _) {
            process.destroyForcibly();
        }
    }

    private static String ownClasses() {
        return Path.of(WarmProcess.class
                        .getProtectionDomain()
                        .getCodeSource()
                        .getLocation()
                        .getPath())
                .toString();
    }

    private static void empty(Path folder) {
        try (Stream<Path> all = Files.walk(folder)) {
            List<Path> deepestFirst = all.filter(path -> !path.equals(folder))
                    .sorted(Comparator.reverseOrder())
                    .toList();
            for (Path path : deepestFirst) {
                Files.delete(path);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// Its folder, empty, for one test after the other.
    static final class Folder implements TempDirFactory {
        @Override
        public Path createTempDirectory(AnnotatedElementContext element, ExtensionContext test) {
            empty(FOLDER);
            return FOLDER;
        }
    }
}
