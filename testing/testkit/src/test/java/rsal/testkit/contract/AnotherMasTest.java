package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import own.Threads;

/// What docs/how-to/another-mas.md shows is what is compiled and tested.
class AnotherMasTest {
    private static final Path TOP = Path.of("../..");
    private static final Path PAGE = TOP.resolve("docs/how-to/another-mas.md");
    private static final Path OWN = Path.of("src/test/java/own");

    @Test
    void showsTheSmallestHostAsItIsTestedHere() throws IOException {
        assertThat(blocks("java"))
                .containsExactly(
                        text(OWN.resolve("Threads.java")),
                        text(OWN.resolve("ThreadsHost.java")),
                        text(OWN.resolve("Mail.java")),
                        text(OWN.resolve("ThreadsTest.java")),
                        text(TOP.resolve("agents/jade/src/main/java/module-info.java")));
    }

    @Test
    void namesTheProviderAsItsFileMust() throws IOException {
        assertThat(blocks("text").getFirst().strip()).isEqualTo(Threads.class.getName());
    }

    @Test
    void showsOfTheBuildWhatStandsThere() throws IOException {
        var poms = new ArrayList<String>();
        for (String pom : List.of("pom.xml", "agents/jade/pom.xml", "apps/cli/pom.xml")) {
            poms.add(packed(text(TOP.resolve(pom))));
        }
        assertThat(blocks("xml"))
                .hasSize(4)
                .allSatisfy(block -> assertThat(poms).anyMatch(pom -> pom.contains(packed(block))));
    }

    private static List<String> blocks(String language) throws IOException {
        return Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
                .matcher(text(PAGE))
                .results()
                .map((MatchResult block) -> block.group(1))
                .toList();
    }

    private static String text(Path file) throws IOException {
        return Files.readString(file);
    }

    private static String packed(String xml) {
        return xml.replaceAll("\\s+", "");
    }
}
