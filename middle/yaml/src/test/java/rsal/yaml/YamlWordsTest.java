package rsal.yaml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.settings.InvalidSettings;

class YamlWordsTest {
    private static String wordsOf(String text) {
        return catchThrowableOfType(InvalidSettings.class, () -> Yaml.read("a.yaml", text))
                .problems()
                .getFirst()
                .message();
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', delimiter = '|', textBlock = """
            a: b: c              | a colon (:) can't stand here
            a: 1\\nb\\n  c: 2     | a name has no colon (:) after it
            a: [1, 2             | ',' or ']' must stand here, not the end of the file
            a: {b: 1, c: 2\\nd: 3 | ',' or '}' must stand here, not ':'
            a: "b                | a quote is opened and not closed
            a: 'b' c             | a text or a number can't stand here, or not indented like this
            a: 1\\n- b           | an entry of a list (-) can't stand here, or not indented like this
            - a\\nb: 1           | a setting (name: value) can't stand here, or not indented like this
            a: }                 | a value must stand here, not '}'
            a: %x                | a text that begins with '%' needs quotes
            a:\\n\\t- b           | lines are indented by spaces, not by tabs
            a: *x                | found undefined alias x
            """)
    void errorsAreReportedInWordsOfThoseWhoWrite(String text, String words) {
        String written = text.replace("\\n", "\n").replace("\\t", "\t") + "\n";
        assertThat(wordsOf(written)).isEqualTo("This is not YAML: %s.".formatted(words));
    }
}
