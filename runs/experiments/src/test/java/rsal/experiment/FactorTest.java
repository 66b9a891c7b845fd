package rsal.experiment;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.util.List;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Parameter;

class FactorTest {
    private static final List<Parameter<?>> KNOWN = List.of(
            Parameter.integer("hunters", 2, 1, 20, "", "How many."),
            Parameter.number("speed", 0.5, 0, 2, "m/s", "How fast."),
            Parameter.text("servers", "", "Where."));

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            hunters | 1,2,4        | 1 2 4
            hunters | 1:10:3       | 1 4 7 10
            hunters | 1:4          | 1 2 3 4
            hunters | 4:1:-1       | 4 3 2 1
            hunters | 1:3,7        | 1 2 3 7
            speed   | 0:0.3:0.1    | 0 0.1 0.2 0.3
            speed   | 1:2:0.4      | 1 1.4 1.8
            servers | a:6665,b:1:2 | a:6665 b:1:2
            """)
    void readsLevels(String argument, String typed, String levels) {
        assertThat(String.join(" ", Factor.read(argument, typed, KNOWN).levels()))
                .isEqualTo(levels);
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            hunter  | 1,2     | Maybe 'hunters' was meant?
            xyz     | 1       | Known are: hunters, speed, servers.
            hunters | 1,99    | 'hunters' must be a whole number from 1 to 20, not '99'.
            hunters | 1,,2    | not ''
            hunters | 1:2:0   | never gets
            hunters | 3:1     | never gets
            hunters | 1:2:0.5 | not '1.5'
            hunters | 2,1:3   | Level '2' is there twice.
            speed   | 1,1.0   | Level '1.0' is there twice.
            speed   | 0:2:1e-9 | has more than
            speed   | 1.2.3:2 | not a range
            """)
    void saysWhatIsWrongWithThem(String argument, String typed, String message) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Factor.read(argument, typed, KNOWN))
                .withMessageContaining("--vary " + argument + "=" + typed)
                .withMessageContaining(message);
    }
}
