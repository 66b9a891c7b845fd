package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

/// Sizes and names of all Java sources: who looks for a class finds one, in a package that can be seen at a glance.
class HouseTest {
    private static final Path ROOT = Path.of("../..");
    private static final int MOST_FILES = 40; // of a package
    private static final int MOST_LINES = 500; // of a file
    private static final String REASON = "Longer than 500 lines, since ";

    static final List<Path> SOURCES = sources();

    private static List<Path> sources() {
        return ArchitecturePageTest.modules().stream()
                .map(module -> ROOT.resolve(module).resolve("src/main/java"))
                .filter(Files::isDirectory)
                .flatMap(HouseTest::filesIn)
                .toList();
    }

    private static Stream<Path> filesIn(Path folder) {
        try (Stream<Path> files = Files.walk(folder)) {
            return files
                    .filter(file -> file.toString().endsWith(".java"))
                    .filter(file -> !file.getFileName().toString().endsWith("-info.java"))
                    .toList()
                    .stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    static String read(Path file) {
        try {
            return Files.readString(file);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Map<Path, Long> by(Function<Path, Path> what) {
        return SOURCES.stream().collect(Collectors.groupingBy(what, TreeMap::new, Collectors.counting()));
    }

    @Test
    void noPackageHasMoreThanFortyFiles() {
        assertThat(SOURCES).hasSizeGreaterThan(1000);
        assertThat(by(Path::getParent))
                .allSatisfy((folder, files) ->
                        assertThat(files).as(folder.toString()).isLessThanOrEqualTo(MOST_FILES));
    }

    @Test
    void noTwoClassesHaveOneName() {
        assertThat(by(Path::getFileName).entrySet().stream().filter(name -> name.getValue() > 1))
                .as("Give one of them a name that says more.")
                .isEmpty();
    }

    @Test
    void filesAreShortOrSayWhyNot() {
        List<Path> longer = SOURCES.stream()
                .filter(file -> read(file).lines().count() > MOST_LINES)
                .toList();
        assertThat(longer)
                .as("Divide it, or say in its first comment: '%s…'", REASON)
                .allSatisfy(file -> assertThat(firstComment(read(file))).contains(REASON));
        assertThat(SOURCES.stream().filter(file -> firstComment(read(file)).contains(REASON)))
                .as("Only these are so long.")
                .containsExactlyElementsOf(longer);
    }

    /// That of the file's class.
    private static String firstComment(String source) {
        return source.lines()
                .dropWhile(line -> !line.startsWith("///"))
                .takeWhile(line -> line.startsWith("///"))
                .collect(Collectors.joining("\n"));
    }
}
