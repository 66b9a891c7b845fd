package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.zip.GZIPOutputStream;
import org.junit.jupiter.api.io.CleanupMode;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.terminal.Exit;
import rsal.testkit.Trials;

/// Types the commands of pages that have no test of their own: those that end by themselves, in their order, in one
/// folder that has the log of a robot.
class HowTosIT {
    /// What commands have that need a bag, or more than a minute.
    private static final List<String> LEFT_OUT = List.of("lab_bag", "explore.yaml", "--odometry-noise");

    @TempDir(factory = WarmProcess.Folder.class, cleanup = CleanupMode.NEVER)
    Path folder;

    @Trials({"localization", "record", "mapping"})
    void commandsDoWhatTheyAreFor(String page) throws Exception {
        writeLog();
        var rsal = new Rsal(folder);
        List<String> commands = DocumentedCommandsTest.commands(Path.of("docs/how-to/" + page + ".md")).stream()
                .filter(HowTosIT::ends)
                .toList();
        assertThat(commands).isNotEmpty();
        for (String command : commands) {
            Ended ended = rsal.run(DocumentedCommandsTest.words(command));
            assertThat(ended.code()).as(command + "\n" + ended.err()).isEqualTo(Exit.SUCCESS);
        }
    }

    private static boolean ends(String command) {
        boolean shows = (command.startsWith("run") && !command.contains("--headless"))
                || (command.startsWith("replay") && !command.contains("--verify"));
        return !shows && LEFT_OUT.stream().noneMatch(command::contains);
    }

    private void writeLog() throws IOException {
        try (var log = new GZIPOutputStream(Files.newOutputStream(folder.resolve("lab.log.gz")))) {
            log.write(RoomLog.whole().getBytes(StandardCharsets.UTF_8));
        }
    }
}
