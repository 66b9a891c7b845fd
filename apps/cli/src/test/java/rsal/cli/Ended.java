package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.TimeUnit;

/// What a process left behind.
///
/// @param code its exit code; 128 + n when signal n ended it, as shells have it
public record Ended(int code, String out, String err) {
    private static final int PATIENCE_SECONDS = 60;

    /// Waits for the end, with nothing more to read for the process.
    static Ended of(Process process) throws Exception {
        return of(process, PATIENCE_SECONDS);
    }

    /// @param patience how long it may take [s]
    static Ended of(Process process, int patience) throws Exception {
        var out = CompletableFuture.supplyAsync(() -> text(process.getInputStream()));
        var err = CompletableFuture.supplyAsync(() -> text(process.getErrorStream()));
        process.getOutputStream().close();
        boolean ended = process.waitFor(patience, TimeUnit.SECONDS);
        if (!ended) {
            process.destroyForcibly();
        }
        assertThat(ended).as("ended in time").isTrue();
        return new Ended(process.exitValue(), out.get(), err.get());
    }

    /// A command that hears Ctrl-C even where this process was told not to, as shells tell what they start in the
    /// background, and so perhaps a whole build.
    static List<String> interruptible(List<String> command) throws Exception {
        var prefix = List.of("env", "--default-signal=INT"); // GNU coreutils 8.31; others must do without
        var probe = new ArrayList<>(prefix);
        probe.add("true");
        if (new ProcessBuilder(probe).start().waitFor() != 0) {
            return command;
        }
        var wrapped = new ArrayList<>(prefix);
        wrapped.addAll(command);
        return wrapped;
    }

    /// Sends a signal, as `kill` does.
    ///
    /// @param name `INT`, `TERM`
    static void signal(String name, Process process) throws Exception {
        int code = new ProcessBuilder("kill", "-" + name, Long.toString(process.pid()))
                .start()
                .waitFor();
        assertThat(code).isZero();
    }

    private static String text(InputStream stream) {
        try (stream) {
            return new String(stream.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
