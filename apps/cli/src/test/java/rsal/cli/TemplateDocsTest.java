package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Pattern;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/// What how-to guides quote of files that `rsal new` makes stands in these.
class TemplateDocsTest {
    private static final Path TEMPLATES = Path.of("../../runs/scenarios/src/main/resources/rsal/templates");
    private static final Pattern BLOCK = Pattern.compile("(?ms)^```(java|yaml)\\n(.*?)^```");

    @ParameterizedTest
    @CsvSource({"own-metric, metric, Spacing.java", "own-controller, controller, Cautious.java"})
    void theyAreQuotedAsTheyAre(String guide, String folder, String program) throws IOException {
        String java = Files.readString(TEMPLATES.resolve(folder).resolve(program));
        String yaml = Files.readString(TEMPLATES.resolve(folder).resolve("scenario.yaml"));
        var blocks = BLOCK.matcher(Files.readString(Path.of("../../docs/how-to", guide + ".md")));
        int quoted = 0;
        while (blocks.find()) {
            if (!blocks.group(2).startsWith("class SpacingTest")) { // of a project of its own
                assertThat(blocks.group(1).equals("java") ? java : yaml).contains(blocks.group(2));
                quoted++;
            }
        }
        assertThat(quoted).isGreaterThan(2);
    }
}
