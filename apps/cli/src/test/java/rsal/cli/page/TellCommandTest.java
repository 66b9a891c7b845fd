package rsal.cli.page;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import picocli.CommandLine;
import rsal.cli.terminal.Exit;
import rsal.engine.OperatorCommand;
import rsal.engine.OperatorCommands;

class TellCommandTest {
    private final StringWriter out = new StringWriter();
    private final StringWriter err = new StringWriter();

    private int send(String... words) {
        return new CommandLine(new TellCommand())
                .setOut(new PrintWriter(out))
                .setErr(new PrintWriter(err))
                .execute(words);
    }

    @Test
    void listsAllCommandsWithTheirParameters() {
        assertThat(send()).isEqualTo(Exit.SUCCESS);
        assertThat(OperatorCommands.ALL).hasSizeGreaterThan(20);
        for (OperatorCommand command : OperatorCommands.ALL) {
            assertThat(out.toString()).contains(command.name() + " ", command.description());
        }
        assertThat(out.toString()).contains("  heading= ", "[rad]", "  arguments.NAME=] ".replace("  ", "  ["));
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            gaol                        | There is no command 'gaol'. Maybe 'goal' was meant?
            goal robot=r x=1 y=2        | 'heading' is missing
            goal robot=r x=1 y=2 z=3    | 'z' is not known here.
            goal robot=r x=1 y=far      | 'y' must be a number
            add kind=CAT x=1 y=2 heading=0 | 'kind' must be one of BOX, BALL, not 'CAT'.
            pause now                   | A parameter is NAME=VALUE, not 'now'.
            """)
    void saysWhatIsWrongBeforeAnybodyIsAsked(String words, String why) {
        assertThat(send(words.split(" ", -1))).isEqualTo(Exit.USAGE);
        assertThat(err.toString()).contains(why);
        assertThat(out.toString()).isEmpty();
    }
}
