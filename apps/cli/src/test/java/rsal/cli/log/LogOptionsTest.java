package rsal.cli.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.io.TempDir;
import rsal.cli.Main;
import rsal.cli.RoomLog;
import rsal.cli.terminal.Exit;
import rsal.testkit.Trials;

/// What commands that follow logs say of odd ones.
class LogOptionsTest {
    private static final Pattern HEADINGS = Pattern.compile("(?m) (\\S+)( \\S+ \\S+) (\\S+)( \\S+ h \\S+)$");

    @TempDir
    Path folder;

    private String reported(String command, String log) throws IOException {
        Path file = Files.writeString(folder.resolve("room.log"), log);
        var err = new StringWriter();
        var rsal = Main.commandLine(new ByteArrayOutputStream());
        rsal.setErr(new PrintWriter(err));
        String[] line = command.equals("map")
                ? new String[] {
                    "map", file.toString(), "--out", folder.resolve("out").toString()
                }
                : new String[] {"localize", file.toString(), "--map", "office", "--global", "--scans", "3"};
        assertThat(rsal.execute(line)).as(err.toString()).isEqualTo(Exit.SUCCESS);
        return err.toString();
    }

    @Trials({"map", "localize"})
    void reportsThatHeadingsAreDegrees(String command) throws IOException {
        String degrees = HEADINGS.matcher(RoomLog.whole()).replaceAll(LogOptionsTest::inDegrees);
        assertThat(reported(command, degrees).lines().filter(line -> line.contains("probably degrees")))
                .singleElement()
                .satisfies(line -> assertThat(line).contains("room.log", "179.5", "multiply them by π / 180"));
    }

    private static String inDegrees(MatchResult line) {
        return String.format(
                Locale.ROOT,
                " %.3f%s %.3f%s",
                Math.toDegrees(Double.parseDouble(line.group(1))),
                line.group(2),
                Math.toDegrees(Double.parseDouble(line.group(3))),
                line.group(4));
    }

    @Trials({"map", "localize"})
    void reportsThatAllScansHaveOneTime(String command) throws IOException {
        String oneTime = RoomLog.whole().replaceAll("(?m) \\S+ h \\S+$", " 12.5 h 12.5");
        assertThat(reported(command, oneTime).lines().filter(line -> line.contains("one time")))
                .singleElement()
                .satisfies(line -> assertThat(line).contains("All 41 scans", "room.log", "12.500 s"));
    }

    @Trials({"map", "localize"})
    void saysNothingOfAnOrdinaryLog(String command) throws IOException {
        assertThat(reported(command, RoomLog.whole())).doesNotContain("degrees", "one time");
    }
}
