package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/// Keeps what the reference tells of commands, agents, devices and formats in step with the code: all between
/// `<!-- from the code: NAME -->` and `<!-- end -->`. `-Drsal.update=true` writes it anew.
class ReferenceTest {
    private static final Path PAGES = Path.of("../../docs/reference");
    private static final Pattern SECTION =
            Pattern.compile("(<!-- from the code: ([^>]+) -->\n).*?(<!-- end -->\n)", Pattern.DOTALL);

    static List<Path> pages() throws IOException {
        try (Stream<Path> files = Files.list(PAGES)) {
            return files.filter(file -> file.toString().endsWith(".md"))
                    .sorted()
                    .toList();
        }
    }

    @ParameterizedTest
    @MethodSource("pages")
    void saysWhatTheCodeSays(Path page) throws IOException {
        String written = Files.readString(page);
        String current = SECTION.matcher(written)
                .replaceAll(section -> Matcher.quoteReplacement(
                        section.group(1) + "\n" + Reference.section(section.group(2)) + "\n" + section.group(3)));
        if (Boolean.getBoolean("rsal.update")) {
            Files.writeString(page, current);
        }
        assertThat(Files.readString(page))
                .as("%s; mend with: ./mvnw -pl apps/cli -am test -Dtest=ReferenceTest -Drsal.update=true", page)
                .isEqualTo(current);
    }

    @Test
    void forgetsNothing() throws IOException {
        var reported = new ArrayList<String>();
        for (Path page : pages()) {
            SECTION.matcher(Files.readString(page)).results().forEach(section -> reported.add(section.group(2)));
        }
        assertThat(reported).doesNotHaveDuplicates().containsAll(Reference.names());
    }
}
