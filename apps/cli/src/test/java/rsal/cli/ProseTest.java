package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.Predicate;
import java.util.function.UnaryOperator;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/// Holds what has been reached of plain English: words that readers stumble over do not come back into documentation
/// and messages, some not into comments; long sentences of the documentation may only get fewer. Who makes them fewer
/// lowers the limit here.
class ProseTest {
    private static final Path ROOT = Path.of("../..");
    private static final int SLACK = 10; // by which a limit may be too high
    private static final Pattern CODE = Pattern.compile("(?ms)^```.*?^```|<!--.*?-->");
    private static final Pattern BLOCK = Pattern.compile("\\n\\s*\\n|\\n(?=[#*|>-]|\\d+\\.)|\\|");
    private static final Pattern LINK = Pattern.compile("\\[([^\\]]*)]\\([^)]*\\)");
    private static final Pattern SENTENCE = Pattern.compile("(?<=[.!?:;])\\s+");
    private static final Pattern TEXT = Pattern.compile("\"((?:[^\"\\\\\n]|\\\\.)*)\"");
    private static final Pattern COMMENT = Pattern.compile("(?m)//[/ ]+(?:@param \\w+ )?(.*)$");
    private static final Pattern SPACES = Pattern.compile("\\s+");
    private static final Pattern SPELLING =
            Pattern.compile("(?i)\\b(colour|metre|centre|behaviour|neighbour)(s|ed|ing)?\\b");

    /// The documentation by path, without code.
    private static final Map<Path, String> PAGES = pages();

    /// Texts of more than one word in the sources of the product, a line for each, by path.
    private static final Map<Path, String> MESSAGES = ofSources(ProseTest::messages);

    /// Comments of these sources, without the names of parameters.
    private static final Map<Path, String> COMMENTS = ofSources(code -> found(COMMENT, code));

    private static Map<Path, String> ofSources(UnaryOperator<String> text) {
        return HouseTest.SOURCES.stream()
                .collect(Collectors.toMap(Function.identity(), file -> text.apply(HouseTest.read(file))));
    }

    private static String messages(String code) {
        String withoutComments =
                code.lines().filter(line -> !line.strip().startsWith("//")).collect(Collectors.joining("\n"));
        return found(TEXT, withoutComments)
                .lines()
                .filter(text -> text.contains(" "))
                .collect(Collectors.joining("\n"));
    }

    /// The first group of each match, a line for each.
    private static String found(Pattern what, String code) {
        return what.matcher(code).results().map(match -> match.group(1)).collect(Collectors.joining("\n"));
    }

    private static Map<Path, String> pages() {
        var pages = new TreeMap<Path, String>();
        for (String folder : List.of("docs", "runs/scenarios/src/main/resources")) {
            try (Stream<Path> files = Files.walk(ROOT.resolve(folder))) {
                files.filter(file -> file.toString().endsWith(".md"))
                        .filter(file -> !file.toString().matches(".*/(node_modules|target|plans)/.*"))
                        .forEach(file -> pages.put(file, prose(file)));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
        pages.put(ROOT.resolve("README.md"), prose(ROOT.resolve("README.md")));
        return pages;
    }

    private static String prose(Path file) {
        try {
            return CODE.matcher(Files.readString(file)).replaceAll("");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Stream<String> sentences(String prose) {
        return BLOCK.splitAsStream(LINK.matcher(prose).replaceAll("$1"))
                .flatMap(SENTENCE::splitAsStream)
                .map(String::strip);
    }

    private static void check(String what, List<String> found, int most) {
        assertThat(found.size())
                .as("There are more %s than before: write it in another way. They are: %s", what, found)
                .isLessThanOrEqualTo(most);
        assertThat(found.size())
                .as("There are fewer %s than before: lower the limit", what)
                .isGreaterThanOrEqualTo(most - SLACK);
    }

    /// @param words of a sentence
    /// @param most how many sentences may be longer
    @ParameterizedTest
    @CsvSource({"25, 42", "30, 12", "35, 2"})
    void sentencesAreShort(int words, int most) {
        check("sentences of more than %d words".formatted(words), longer(words, _ -> true), most);
    }

    /// Records of decisions are not written again, so they keep some.
    @Test
    void sentencesForUsersAreShorter() {
        List<String> found = longer(25, file -> !file.toString().contains("/decisions/"));
        check("sentences for users of more than 25 words", found, 0);
    }

    private static List<String> longer(int words, Predicate<Path> pages) {
        var found = new ArrayList<String>();
        PAGES.forEach((file, prose) -> sentences(prose)
                .filter(_ -> pages.test(file))
                .filter(sentence -> SPACES.splitAsStream(sentence).count() > words)
                .forEach(sentence -> found.add(file + ": " + sentence)));
        return found;
    }

    @ParameterizedTest
    @ValueSource(
            strings = {"anew", "likewise", "whoever", "lest", "by custom", "sees to it", "what came of", "reckon(ed|s)?"
            })
    void wordsThatReadersStumbleOverDoNotComeBack(String word) {
        expectNone(word, List.of(PAGES, MESSAGES));
    }

    @ParameterizedTest
    @ValueSource(strings = {"anew", "likewise", "whoever", "what came of", "reckon(ed|s)?"})
    void someOfThemAreNotInCommentsEither(String word) {
        expectNone(word, List.of(COMMENTS));
    }

    private static void expectNone(String word, List<Map<Path, String>> places) {
        var isUsed = Pattern.compile("(?i)\\b%s\\b".formatted(word)).asPredicate();
        var found = new ArrayList<String>();
        places.forEach(texts -> texts.forEach((file, text) ->
                text.lines().filter(isUsed).forEach(line -> found.add("%s: %s".formatted(file, line)))));
        assertThat(found).as("uses of '%s': write it in another way", word).isEmpty();
    }

    @Test
    void spellingIsAmerican() {
        var found = new ArrayList<String>();
        PAGES.forEach((file, prose) ->
                SPELLING.matcher(prose).results().forEach(word -> found.add("%s: %s".formatted(file, word.group()))));
        assertThat(found).isEmpty();
    }
}
