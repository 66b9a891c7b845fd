package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.OutputStream;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import rsal.cli.terminal.Exit;
import rsal.cli.terminal.Subcommand;

class InternalErrorTest {
    private final StringWriter err = new StringWriter();

    @Command(name = "break")
    static final class Breaking extends Subcommand {
        @Override
        protected int run() {
            throw new IllegalStateException("a wheel came off");
        }
    }

    @Test
    void isReportedInTwoLinesAndWrittenDownInFull() throws Exception {
        assertThat(execute("break")).isEqualTo(Exit.INTERNAL);
        assertThat(err.toString()).contains("a wheel came off").doesNotContain("\tat ");
        assertThat(err.toString().lines()).hasSize(2);

        Matcher log = Pattern.compile("is in (\\S+);").matcher(err.toString());
        assertThat(log.find()).isTrue();
        Path file = Path.of(log.group(1));
        assertThat(file).content().contains("rsal break", "a wheel came off", "\tat rsal.cli.InternalErrorTest");
        Files.delete(file);
    }

    @Test
    void isShownInFullToThoseWhoDebug() {
        assertThat(execute("break", "--debug")).isEqualTo(Exit.INTERNAL);
        assertThat(err.toString()).contains("a wheel came off", "\tat rsal.cli.InternalErrorTest");
    }

    private int execute(String... line) {
        CommandLine rsal = Main.commandLine(OutputStream.nullOutputStream());
        rsal.addSubcommand(new Breaking());
        rsal.setErr(new PrintWriter(err, true));
        rsal.getSubcommands().get("break").setErr(new PrintWriter(err, true));
        return rsal.execute(line);
    }
}
