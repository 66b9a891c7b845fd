package rsal.cli.run;

import java.io.EOFException;
import java.io.FileDescriptor;
import java.io.FileInputStream;
import java.io.FileOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.stream.Collectors;
import picocli.CommandLine.Command;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;
import rsal.engine.report.RunBroken;
import rsal.environment.EnvironmentSession;
import rsal.frame.FramePipe;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;

/// `rsal environments`: simulates worlds for a program that has started this process, such as the Python package. It
/// asks by frames on stdin, and gets answers on stdout. The process ends when stdin does.
@Command(
        name = "environments",
        hidden = true, // not for people
        description = "Simulate worlds for the Python package, by frames on stdin and stdout.")
public final class EnvironmentsCommand extends Subcommand {
    @Override
    protected int run() throws IOException {
        var frames = new FramePipe(new FileInputStream(FileDescriptor.in), new FileOutputStream(FileDescriptor.out));
        System.setOut(System.err); // what anything else prints must not be among the frames
        try (var session = new EnvironmentSession()) {
            while (true) {
                answer(session, frames);
            }
        } catch (EOFException _) {
            return Exit.SUCCESS;
        }
    }

    private static void answer(EnvironmentSession session, FramePipe frames) throws IOException {
        FramePipe.Frame request = frames.readFrame();
        EnvironmentSession.Answer answer;
        try {
            answer = session.answer(request.words(), numbers(request.arrays()));
        } catch (InvalidSettings e) {
            refuse(frames, e.problems().stream().map(Problem::toString).collect(Collectors.joining("\n")));
            return;
        } catch (IllegalArgumentException | IndexOutOfBoundsException | RunBroken e) {
            refuse(frames, String.valueOf(e.getMessage()));
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
