package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/// Does what the first tutorial says, and sees what it says.
class TutorialIT {
    private static final Path TUTORIAL = Path.of("../../docs/tutorials/first-scenario.md");
    private static final String PROMPT = "$ ./rsal ";

    @TempDir
    Path folder;

    @Test
    void whatTheTutorialShowsIsWhatHappens() throws Exception {
        Files.writeString(folder.resolve("patrol.yaml"), blocks("yaml").getFirst());
        int commands = 0;
        for (String console : blocks("console")) {
            String out = "";
            for (String line : console.lines().toList()) {
                if (line.startsWith(PROMPT)) {
                    Ended ended =
                            new Rsal(folder).run(line.substring(PROMPT.length()).split(" "));
                    assertThat(ended.code()).as(line + "\n" + ended.err()).isEqualTo(Exit.SUCCESS);
                    out = ended.out();
                    commands++;
                } else {
                    assertThat(out.lines()).contains(line);
                }
            }
        }
        assertThat(commands).isPositive();
    }

    @Test
    void theMistakeItProposesIsExplained() throws Exception {
        Files.writeString(
                folder.resolve("patrol.yaml"), blocks("yaml").getFirst().replace("model:", "modle:"));
        Ended ended = new Rsal(folder).run("validate", "patrol.yaml");
        assertThat(ended.code()).isEqualTo(Exit.INVALID);
        assertThat(ended.out()).contains("(modle)", "Maybe (model)");
    }

    private static List<String> blocks(String language) throws IOException {
        var blocks = new ArrayList<String>();
        Pattern.compile("```" + language + "\n(.*?)```", Pattern.DOTALL)
                .matcher(Files.readString(TUTORIAL))
                .results()
                .map((MatchResult block) -> block.group(1))
                .forEach(blocks::add);
        return blocks;
    }
}
