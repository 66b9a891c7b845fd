package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import picocli.CommandLine.ParameterException;

/// Commands in the documentation are commands: the command line itself reads their names, options and values. Tutorials
/// and others are run, too, by tests of their own.
class DocumentedCommandsTest {
    private static final Path TOP = Path.of("../..").toAbsolutePath().normalize();
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```[a-z]*\\n(.*?)^```$");
    private static final Pattern COMMAND = Pattern.compile("(?m)^(?:\\$ )?(?:\\./|~/\\S+/)?rsal ([a-z].*)$");

    /// Behind which a line explains itself, or its output goes elsewhere.
    private static final Pattern REST = Pattern.compile("\\s{2,}.*|\\s#.*|\\s[|>&].*|\\s2>.*");

    private static final Pattern WORD = Pattern.compile("\"([^\"]*)\"|'([^']*)'|(\\S+)");

    static List<Path> pages() throws IOException {
        return LinksTest.pages().stream()
                .filter(page -> !page.startsWith("docs/decisions") && !page.startsWith("docs/plans"))
                .toList();
    }

    static List<String> commands(Path page) throws IOException {
        return BLOCK.matcher(Files.readString(TOP.resolve(page)))
                .results()
                .flatMap(block -> COMMAND.matcher(block.group(1)).results())
                .map(command -> REST.matcher(command.group(1)).replaceFirst(""))
                .filter(command -> !command.matches(".*[…\\[<(].*|dist.*")) // a form, and what the launcher does itself
                .toList();
    }

    static String[] words(String command) {
        return WORD.matcher(command)
                .results()
                .map(DocumentedCommandsTest::unquoted)
                .toArray(String[]::new);
    }

    private static String unquoted(MatchResult word) {
        return Stream.of(1, 2, 3)
                .map(word::group)
                .filter(text -> text != null)
                .findFirst()
                .orElseThrow();
    }

    @ParameterizedTest
    @MethodSource("pages")
    void areRead(Path page) throws IOException {
        var wrong = new ArrayList<String>();
        for (String command : commands(page)) {
            try {
                Main.commandLine(OutputStream.nullOutputStream()).parseArgs(words(command));
            } catch (ParameterException e) {
                wrong.add("rsal %s: %s".formatted(command, e.getMessage()));
            }
        }
        assertThat(wrong).as(page.toString()).isEmpty();
    }

    @Test
    void thereAreMany() throws IOException {
        int count = 0;
        for (Path page : pages()) {
            count += commands(page).size();
        }
        assertThat(count).isGreaterThan(100);
    }
}
