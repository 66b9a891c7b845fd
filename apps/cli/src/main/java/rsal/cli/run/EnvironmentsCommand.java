package rsal.cli.run;

import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import picocli.CommandLine.Option;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.engine.SteppedWatch;
import rsal.engine.report.RunBroken;
import rsal.environment.EnvironmentSession;
import rsal.frame.FramePipe;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;
import rsal.time.AllowedToReadWallClock;

/// `rsal environments`: simulates worlds for a program that has started this process, such as the Python package. It
/// asks by frames on stdin, and gets answers on stdout. The process ends when stdin does, by the request `close`, and
/// when an agent never returns: no thread can be taken from it.
@Command(
        name = "environments",
        hidden = true, // not for people
        description = "Simulate worlds for the Python package, by frames on stdin and stdout.")
@AllowedToReadWallClock("It looks once a second whether agents return.")
public final class EnvironmentsCommand extends Subcommand {
    private static final Duration LOOK = Duration.ofSeconds(1);

    @Option(
            names = "--patience",
            paramLabel = "SECONDS",
            defaultValue = "20",
            description = "In how many seconds an agent has to return.")
    private int patience;

    @Override
    protected int run() throws IOException {
        var frames = new FramePipe(new FileInputStream(FileDescriptor.in), new FileOutputStream(FileDescriptor.out));
        System.setOut(System.err); // what anything else prints must not be among the frames
        var watch = new SteppedWatch(patience);
        Thread.ofPlatform().daemon().name("agent-watch").start(() -> look(watch));
        try (var session = new EnvironmentSession(watch)) {
            while (true) {
                FramePipe.Frame request = frames.readFrame();
                if ("close".equals(request.words().get("request"))) {
                    return Exit.SUCCESS;
                }
                answer(session, request, frames);
            }
        } catch (EOFException _) {
            return Exit.SUCCESS;
        }
    }

    /// Ends the process, and those of its agents, when an agent does not return.
    private static void look(SteppedWatch watch) {
        while (true) {
            try {
                Thread.sleep(LOOK);
            } catch (InterruptedException _) {
                return;
            }
            watch.look().ifPresent(why -> {
                System.err.println(why);
                System.err.flush();
                ProcessHandle.current().descendants().forEach(ProcessHandle::destroyForcibly);
                Runtime.getRuntime().halt(Exit.INTERNAL);
            });
        }
    }

    private static void answer(EnvironmentSession session, FramePipe.Frame request, FramePipe frames)
            throws IOException {
        EnvironmentSession.Answer answer;
        try {
            answer = session.answer(request.words(), numbers(request.arrays()));
        } catch (InvalidSettings e) {
            refuse(frames, e.problems().stream().map(Problem::toString).collect(Collectors.joining("\n")));
            return;
        } catch (IllegalArgumentException | IndexOutOfBoundsException | RunBroken e) {
            refuse(frames, String.valueOf(e.getMessage()));
            return;
        } catch (RuntimeException e) { // a bug of ours: the worlds that are not concerned can go on
            refuse(frames, "An error inside RSAL: %s".formatted(e));
            return;
        }
        frames.write(to -> {
            answer.words().forEach(to::put);
            for (int i = 0; i < answer.arrays().size(); i++) {
                to.put("array" + i, answer.arrays().get(i));
            }
        });
    }

    private static float[] numbers(ByteBuffer bytes) {
        var numbers = new float[bytes.remaining() / Float.BYTES];
        bytes.asFloatBuffer().get(numbers);
        return numbers;
    }

    private static void refuse(FramePipe frames, String why) throws IOException {
        frames.write(to -> to.put("error", why));
    }
}
