package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeSet;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/// The table of modules on the page about the architecture is true.
class ArchitecturePageTest {
    private static final Path ROOT = Path.of("../..");
    private static final Pattern ROW = Pattern.compile("(?m)^\\| `([\\w/-]+)` \\| ([^|]+) \\| [^|]+ \\| ([^|]+) \\|$");
    private static final Pattern MODULE = Pattern.compile("(?m)^module ([\\w.]+)");
    private static final Pattern REQUIRES = Pattern.compile("(?m)^ +requires (?:transitive |static )*(rsal[\\w.]+);");
    private static final Pattern IN_POM = Pattern.compile("<module>([^<]+)</module>");
    private static final Map<String, Row> ROWS = rows();

    /// @param knows what it says to know, by folder
    record Row(String folder, String module, List<String> knows) {
        @Override
        public String toString() {
            return folder;
        }

        private boolean isJava() {
            return Files.exists(ROOT.resolve(folder).resolve("src/main/java/module-info.java"));
        }

        /// Modules that it requires.
        private Set<String> requires() {
            return all(REQUIRES, read(folder + "/src/main/java/module-info.java"));
        }
    }

    private static Map<String, Row> rows() {
        var rows = new LinkedHashMap<String, Row>();
        ROW.matcher(read("docs/concepts/architecture.md")).results().forEach(row -> rows.put(row.group(1), row(row)));
        return rows;
    }

    private static Row row(MatchResult row) {
        return new Row(
                row.group(1),
                row.group(2).replace("`", "").strip(),
                List.of(row.group(3).strip().split(", ", -1)));
    }

    private static String read(String file) {
        try {
            return Files.readString(ROOT.resolve(file));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Set<String> all(Pattern pattern, String text) {
        return pattern.matcher(text)
                .results()
                .map(found -> found.group(1))
                .collect(Collectors.toCollection(TreeSet::new));
    }

    static List<Row> javaModules() {
        return ROWS.values().stream().filter(Row::isJava).toList();
    }

    /// Folders of all modules that are built.
    static Set<String> modules() {
        return all(IN_POM, read("pom.xml"));
    }

    @Test
    void itListsAllModules() {
        Set<String> built = modules();
        built.removeIf(module -> module.startsWith("testing/"));
        assertThat(ROWS.keySet()).containsAll(built);
        ROWS.keySet().forEach(folder -> assertThat(ROOT.resolve(folder)).isDirectory());
    }

    @ParameterizedTest
    @MethodSource("javaModules")
    void itNamesThemAsTheyAre(Row row) {
        assertThat(all(MODULE, read(row.folder + "/src/main/java/module-info.java")))
                .containsExactly(row.module);
    }

    /// What a module requires is in its row, or known to what is there; and nothing else is.
    @ParameterizedTest
    @MethodSource("javaModules")
    void itSaysWhatTheyKnow(Row row) {
        var known = new TreeSet<String>();
        named(row).forEach(other -> addKnown(other, known));
        var required = new TreeSet<String>();
        row.requires().forEach(module -> addRequired(module, required));
        assertThat(known).as("known by %s", row).containsAll(row.requires());
        assertThat(required)
                .as("required by %s", row)
                .containsAll(named(row).stream().map(Row::module).toList());
    }

    /// `agent api` is `agents/api`, `devices` is `middle/devices`.
    private static List<Row> named(Row row) {
        return row.knows.stream()
                .filter(name -> !name.equals("nothing"))
                .map(name -> ROWS.values().stream()
                        .filter(other -> other.folder.endsWith("/" + name.replaceFirst("^agent ", "")))
                        .findFirst()
                        .orElseThrow(
                                () -> new AssertionError("'%s' in the row of %s is no module.".formatted(name, row))))
                .toList();
    }

    private static void addKnown(Row row, Set<String> known) {
        if (known.add(row.module)) {
            named(row).forEach(other -> addKnown(other, known));
        }
    }

    private static void addRequired(String module, Set<String> required) {
        if (required.add(module)) {
            ROWS.values().stream()
                    .filter(row -> row.module.equals(module) && row.isJava())
                    .forEach(row -> row.requires().forEach(other -> addRequired(other, required)));
        }
    }
}
