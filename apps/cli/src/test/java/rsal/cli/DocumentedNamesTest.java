package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/// Types that Java code in the documentation names are there: in the sources, in Java's library, or on the page itself.
class DocumentedNamesTest {
    private static final Path TOP = Path.of("../..").toAbsolutePath().normalize();
    private static final Pattern DECLARED = Pattern.compile("\\b(?:class|record|interface|enum)\\s+([A-Z]\\w*)");
    private static final Pattern IMPORTED = Pattern.compile("\\bimport (?:static )?[\\w.]+\\.([A-Z]\\w*)");
    private static final Pattern NO_CODE =
            Pattern.compile("\"(?:[^\"\\\\]|\\\\.)*\"|//[^\n]*|/\\*.*?\\*/", Pattern.DOTALL);
    private static final Pattern TYPE = Pattern.compile("(?<![\\w.])([A-Z]\\w*[a-z]\\w*)");

    /// Of a story that a page tells, without a declaration.
    private static final Set<String> TOLD = Set.of("Delivered", "Door", "Opened");

    private static final Set<String> KNOWN = known();

    private static Set<String> known() {
        var known = new HashSet<>(TOLD);
        for (String room : List.of("agents", "apps", "middle", "robots", "runs", "testing")) {
            try (Stream<Path> files = Files.walk(TOP.resolve(room))) {
                files.filter(file -> file.toString().endsWith(".java"))
                        .filter(file -> file.toString().contains("/src/"))
                        .forEach(file -> collect(read(file), known));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }
        return known;
    }

    private static void collect(String source, Set<String> names) {
        for (Pattern pattern : List.of(DECLARED, IMPORTED)) {
            pattern.matcher(source).results().forEach(name -> names.add(name.group(1)));
        }
    }

    private static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static List<Path> pages() throws IOException {
        return LinksTest.pages().stream()
                .filter(page -> !page.startsWith("docs/decisions") && !page.startsWith("docs/plans"))
                .filter(page ->
                        !TutorialIT.blocks(read(TOP.resolve(page)), "java").isEmpty())
                .toList();
    }

    @ParameterizedTest
    @MethodSource("pages")
    void areThere(Path page) {
        var known = new HashSet<>(KNOWN);
        List<String> blocks = TutorialIT.blocks(read(TOP.resolve(page)), "java");
        blocks.forEach(block -> collect(block, known));
        var unknown = new TreeSet<String>();
        blocks.forEach(block -> TYPE.matcher(NO_CODE.matcher(block).replaceAll(" "))
                .results()
                .map(type -> type.group(1))
                .filter(type -> !known.contains(type) && !isOfJava(type))
                .forEach(unknown::add));
        assertThat(unknown).as("types that %s names", page).isEmpty();
    }

    private static boolean isOfJava(String type) {
        try {
            Class.forName("java.lang." + type, false, ClassLoader.getPlatformClassLoader());
            return true;
        } catch (ClassNotFoundException _) {
            return false;
        }
    }
}
