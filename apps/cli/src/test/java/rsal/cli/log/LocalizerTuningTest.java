package rsal.cli.log;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.cli.Ended;
import rsal.cli.Main;
import rsal.cli.RoomLog;
import rsal.cli.terminal.Exit;
import rsal.testkit.LongTest;

class LocalizerTuningTest {
    @TempDir
    private Path folder;

    private record Ended(int code, String errors, String err) {}

    private Ended localize(String... options) throws IOException {
        Path log = Files.writeString(folder.resolve("room.log"), RoomLog.whole());
        var line = new ArrayList<>(
                List.of("localize", log.toString(), "--map-from-half", "--odometry-noise", "0.05,2,3", "--json"));
        line.addAll(List.of(options));
        var out = new ByteArrayOutputStream();
        var err = new StringWriter();
        var rsal = Main.commandLine(out);
        rsal.setErr(new PrintWriter(err, true));
        int code = rsal.execute(line.toArray(String[]::new));
        rsal.getOut().flush();
        return new Ended(code, errors(out.toString(StandardCharsets.UTF_8)), err.toString());
    }

    /// How far off it was at each scan.
    private static String errors(String json) {
        return Pattern.compile("\"error\":[0-9.eE+-]+")
                .matcher(json)
                .results()
                .map(MatchResult::group)
                .collect(Collectors.joining(" "));
    }

    @Test
    @LongTest
    void parametersHaveTheirUsualValuesUnlessTheyAreSet() throws IOException {
        Ended usual = localize();
        assertThat(usual.code()).isEqualTo(Exit.SUCCESS);
        assertThat(usual.errors()).contains("error");
        assertThat(localize("--set", "odometryNoiseScale=2", "--set", "hitDeviation=0.1")
                        .errors())
                .isEqualTo(usual.errors());
        for (String set :
                new String[] {"odometryNoiseScale=6", "hitDeviation=0.4", "independentBeams=2", "updateAngle=60"}) {
            assertThat(localize("--set", set).errors()).as(set).isNotEqualTo(usual.errors());
        }
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            odometryNoiseScal=1 | Maybe 'odometryNoiseScale' was meant?
            beams=5         | Option '--set' can't set 'beams' here. Use --beams.
            hitDeviation=9  | 'hitDeviation' must be a number from 0.01 to 1 [m], not '9.0'.
            randomShare=x   | 'randomShare' must be a number from 0.001 to 0.5, not 'x'.
            hitDeviation    | is not a name and its value
            """)
    void whatCanNotBeSetIsRefused(String set, String why) throws IOException {
        Ended refused = localize("--set", set);
        assertThat(refused.code()).isEqualTo(Exit.USAGE);
        assertThat(refused.err()).contains(why);
    }
}
