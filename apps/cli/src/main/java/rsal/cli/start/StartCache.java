package rsal.cli.start;

import java.io.File;
import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;

/// The cache from which a release starts (JEP 483, 514: ahead-of-time class loading and linking). It holds the classes
/// of a short run, loaded and linked, and depends on the Java runtime and the machine. So a release can't carry it:
/// the first start makes it in the background. Without it all works, and starts slower. An empty file says that Java
/// can't make one, so that not each start tries again.
///
/// The release's script names the file by the property `rsal.cache`, where it has found a folder that can be written.
///
/// @param file where the cache is, or will be
public record StartCache(Path file) {
    private static final Path NICE = Path.of("/usr/bin/nice");
    private static final long LONGEST = 180; // s
    private static final List<String> SHORT_RUN =
            List.of("run", "--once", "--port", "0", "--speed", "max", "--for", "5", "--json");

    /// That of this process; empty where the script names none.
    public static Optional<StartCache> ofThisProcess() {
        return Optional.ofNullable(System.getProperty("rsal.cache"))
                .filter(file -> !file.isEmpty())
                .map(file -> new StartCache(Path.of(file)));
    }

    /// Whether it was made, or can't be.
    public boolean wasTried() {
        return Files.exists(file);
    }

    private boolean isThere() throws IOException {
        return Files.exists(file) && Files.size(file) > 0;
    }

    /// Starts another process, which makes the cache and outlives this one. It has the lowest priority where the system
    /// has a `nice`. A cache that can't be made is no reason to tell anybody: all else works.
    public void makeInBackground() {
        try {
            var command = new ArrayList<String>();
            if (File.separatorChar == '/' && Files.isExecutable(NICE)) {
                command.addAll(List.of(NICE.toString(), "-n", "19"));
            }
            command.addAll(java(List.of("-Drsal.cache=" + file, "-Xmx64m", "-XX:TieredStopAtLevel=1")));
            command.add("prepare");
            start(command);
        } catch (IOException _) { // as above
        }
    }

    /// Makes the cache, unless it is there or another process makes it.
    ///
    /// @return whether it is there now
    /// @throws IOException if it can't be written
    boolean make() throws IOException, InterruptedException {
        if (isThere()) {
            return true;
        }
        Files.createDirectories(file.getParent());
        Path lock = file.resolveSibling(file.getFileName() + ".lock");
        try (var channel = FileChannel.open(lock, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
                var held = channel.tryLock()) {
            if (held == null || isThere()) {
                return isThere();
            }
            Path fresh = file.resolveSibling(file.getFileName() + ".new");
            var command = new ArrayList<>(java(List.of("-XX:AOTCacheOutput=" + fresh)));
            command.addAll(SHORT_RUN);
            Process run = start(command);
            if (!run.waitFor(LONGEST, TimeUnit.SECONDS)) {
                run.destroyForcibly().waitFor();
            }
            if (!Files.exists(fresh)) {
                Files.createFile(fresh);
            }
            Files.move(fresh, file, StandardCopyOption.REPLACE_EXISTING);
            return isThere();
        }
    }

    private static Process start(List<String> command) throws IOException {
        var builder = new ProcessBuilder(command)
                .redirectOutput(ProcessBuilder.Redirect.DISCARD)
                .redirectError(ProcessBuilder.Redirect.DISCARD);
        builder.environment().remove(Companion.VARIABLE); // the cache is made even if that program ends before
        Process process = builder.start();
        process.getOutputStream().close();
        return process;
    }

    private static List<String> java(List<String> more) {
        return OwnProgram.command(
                option -> !option.startsWith("-XX:AOTCache") && !option.startsWith("-Drsal.cache="), more);
    }
}
