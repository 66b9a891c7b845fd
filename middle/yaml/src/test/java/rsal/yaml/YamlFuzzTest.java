package rsal.yaml;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;

import java.nio.charset.StandardCharsets;
import java.time.Duration;
import java.util.Random;
import org.junit.jupiter.api.Assertions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Problem;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Value;

/// Whatever is in a settings file: it is read, or refused in words. It never hangs, nor throws anything else.
class YamlFuzzTest {
    private static final String GOOD = """
            title: Cart # a comment
            body: {length: 0.3, width: 0.2, center: [0, -0.1]}
            list:
              - one
              - "two\\n"
              - {a: 1, b: true, c: ~}
            anchor: &x {deep: [1, 2, 3]}
            alias: *x
            text: |
              lines
              of text
            """;
    private static final String ODD = "&*!%@`{}[]:-?|>#'\"\\\n\t ,~.0123456789ex<=\0\u0085\uFEFF\uD83D";

    @Test
    void aDamagedFileIsReadOrRefused() {
        for (long seed = 0; seed < 3000; seed++) {
            var random = new Random(seed);
            var text = new StringBuilder(GOOD);
            for (int change = 0; change <= random.nextInt(6); change++) {
                int at = random.nextInt(text.length());
                char odd = ODD.charAt(random.nextInt(ODD.length()));
                switch (random.nextInt(4)) {
                    case 0 -> text.setCharAt(at, odd);
                    case 1 -> text.insert(at, odd);
                    case 2 -> text.delete(at, Math.min(text.length(), at + random.nextInt(20)));
                    default -> text.insert(at, GOOD, 0, random.nextInt(GOOD.length()));
                }
                text.append(' ');
            }
            readOrRefuse("seed " + seed, text.toString());
        }
    }

    @Test
    void aFileCutShortIsReadOrRefused() {
        for (int length = 0; length < GOOD.length(); length++) {
            readOrRefuse("cut to " + length, GOOD.substring(0, length));
        }
    }

    @Test
    void noiseIsReadOrRefused() {
        for (long seed = 0; seed < 2000; seed++) {
            var bytes = new byte[new Random(seed).nextInt(200)];
            new Random(seed).nextBytes(bytes);
            readOrRefuse("seed " + seed, new String(bytes, StandardCharsets.ISO_8859_1));
        }
    }

    @ParameterizedTest
    @ValueSource(
            strings = {
                "a: !!java.net.URL [http://localhost]",
                "a: !custom 1",
                "a: !!set {x}",
                "a: !!float abc",
                "a: !!int 1_000",
                "a: !!bool maybe",
                "!!map {a: !!binary 'R0lG'}",
                "? [complex, key]\n: value",
                "a: &a [*a]",
                "a: &a {b: *a}",
                "a: 1\na: 2",
                "{a: 1, a: 2}",
                "a: *nobody",
                "- a list",
                "just text",
                "",
                "---\na: 1\n---\nb: 2",
                "%YAML 9.9\n---\na: 1",
                "a: 99999999999999999999",
                "a: 0xFFFFFFFFFFFFFFFFFFFF",
                "a:\n\t- tab",
                "a: [1, 2",
                "a: 'open",
                "\0",
                "a: \u0007"
            })
    void whatIsNotPlainSettingsIsRefused(String text) {
        assertThatExceptionOfType(InvalidSettings.class)
                .isThrownBy(() -> Yaml.read("test.yaml", text))
                .satisfies(e -> assertThat(e.problems()).isNotEmpty())
                .withMessageStartingWith("test.yaml");
    }

    @Test
    void aBombOfAliasesIsRefusedQuickly() {
        var bomb = new StringBuilder("a0: &a0 [x, x, x, x, x, x, x, x, x]\n");
        for (int i = 1; i < 30; i++) {
            bomb.append("a%d: &a%d [%s]\n".formatted(i, i, ("*a" + (i - 1) + ", ").repeat(9)));
        }
        refused(bomb.toString());
    }

    @Test
    void deepNestingIsRefused() {
        refused("a: " + "[".repeat(100_000));
        refused("a: " + "[".repeat(5000) + "]".repeat(5000));
        refused("a: " + "{b: ".repeat(100_000));
        refused("- ".repeat(100_000));
        refused("a: " + "!".repeat(1000));
        var steps = new StringBuilder();
        for (int i = 0; i < 1000; i++) {
            steps.append(" ".repeat(i)).append("a:\n");
        }
        refused(steps.toString());
    }

    @Test
    void tooMuchIsRefused() {
        refused("a: " + "x".repeat(Yaml.MAX_CHARACTERS));
        refused("a: [" + "1,".repeat(100_000) + "1]");
    }

    @ParameterizedTest
    @ValueSource(strings = {"1e999", "-1e999", ".inf", ".nan", "1e308", "9223372036854775807", "1e-999"})
    void hugeNumbersAreRefusedOrFinite(String number) {
        var problems = new Problems();
        var section = new Section("", Yaml.read("test.yaml", "a: " + number), problems);
        double value = section.number("a", 1);
        assertThat(Double.isFinite(value)).isTrue();
        assertThat(problems.isEmpty()).isEqualTo(Double.isFinite(parsed(number)));
    }

    @ParameterizedTest
    @CsvSource({"10, 10", "010, 10", "0x1F, 31", "0o17, 15", "-7, -7", "+7, 7", "0, 0"})
    void wholeNumbersAreReadAsYaml12Says(String text, long number) {
        assertThat(Yaml.read("test.yaml", "a: " + text).find("a"))
                .hasValueSatisfying(
                        value -> assertThat(((Value.Scalar) value).value()).isEqualTo(number));
    }

    @Test
    void aSectionNamesWhatIsWrongAndWhatWasMeant() {
        var problems = new Problems();
        var section = new Section("robots.prey", Yaml.read("hunt.yaml", """
                modle: pioneer2dx
                speed: fast
                pose: [1, 2]
                """), problems);
        section.text("model");
        section.number("speed");
        section.pose("pose");
        section.done();
        assertThat(problems.all())
                .extracting(Problem::toString)
                .satisfiesExactly(
                        wrong -> assertThat(wrong)
                                .contains("hunt.yaml:2:8: 'robots.prey.speed' must be a number, not 'fast'"),
                        list -> assertThat(list)
                                .contains("hunt.yaml:3:7: 'robots.prey.pose' must be a list of 3 numbers"),
                        unknown -> assertThat(unknown)
                                .contains("hunt.yaml:1:1: 'modle' is not known")
                                .contains("'model'"));
    }

    private static double parsed(String number) {
        return switch (number) {
            case ".inf" -> Double.POSITIVE_INFINITY;
            case ".nan" -> Double.NaN;
            default -> Double.parseDouble(number);
        };
    }

    private static void refused(String text) {
        Assertions.assertTimeoutPreemptively(
                Duration.ofSeconds(20),
                () -> assertThatExceptionOfType(InvalidSettings.class).isThrownBy(() -> Yaml.read("test.yaml", text)));
    }

    private static void readOrRefuse(String which, String text) {
        try {
            assertThat(Yaml.read("test.yaml", text).describe()).isNotEmpty();
        } catch (InvalidSettings e) {
            assertThat(e.problems()).as(which).isNotEmpty();
        } catch (RuntimeException | StackOverflowError e) {
            throw new AssertionError(which + ": " + text, e);
        }
    }
}
