package rsal.release;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/// The script that starts a release, with a Java that only prints what it is given.
class ReleaseScriptTest {
    private static final String JAVA = """
            #!/bin/sh
            [ "$1" != -version ] || { echo 'openjdk version "%s.0.1"' >&2; exit; }
            for each; do echo "$each"; done
            exit 4
            """;

    @TempDir
    private Path folder;

    private Path top;

    @BeforeEach
    void unpack() throws IOException {
        top = Files.createDirectory(folder.resolve("a release"));
        program(top.resolve("rsal"), script());
        program(top.resolve("runtime/bin/java"), JAVA.formatted("25"));
        Files.createDirectory(top.resolve("lib"));
        Files.writeString(top.resolve("lib/java.options"), "-Xlog:disable\n");
    }

    private static String script() throws IOException {
        try (var in = Objects.requireNonNull(ReleaseScriptTest.class.getResourceAsStream("unpacked/rsal"))) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        }
    }

    private static void program(Path file, String text) throws IOException {
        Files.createDirectories(file.getParent());
        Files.writeString(file, text);
        assertThat(file.toFile().setExecutable(true)).isTrue();
    }

    private record Result(int code, List<String> out) {}

    private static Result run(Path script, Map<String, String> environment, String... arguments) throws Exception {
        var builder = new ProcessBuilder(Stream.concat(Stream.of(script.toString()), Stream.of(arguments))
                        .toList())
                .redirectErrorStream(true);
        builder.environment().keySet().removeAll(List.of("JAVA_HOME", "XDG_CACHE_HOME", "RSAL_CACHE", "HOME"));
        builder.environment().putAll(environment);
        Process process = builder.start();
        process.getOutputStream().close();
        List<String> out = process.inputReader(StandardCharsets.UTF_8).readAllLines();
        assertThat(process.waitFor(20, TimeUnit.SECONDS)).isTrue();
        return new Result(process.exitValue(), out);
    }

    @Test
    void startsTheRuntimeBesideItAndKeepsItsExitCode() throws Exception {
        Result result = run(top.resolve("rsal"), Map.of(), "run", "my hunt.yaml", "");
        assertThat(result.code()).isEqualTo(4);
        assertThat(result.out())
                .startsWith("@" + top + "/lib/java.options")
                .contains("-Drsal.page=" + top + "/page", "-cp", top + "/lib/rsal-cli.jar")
                .endsWith("rsal.cli.Main", "run", "my hunt.yaml", "");
        assertThat(result.out())
                .filteredOn(line -> line.startsWith("-XX:AOTCache=" + top + "/cache/start-"))
                .hasSize(1);
    }

    @Test
    void worksThroughLinks() throws Exception {
        Path link = Files.createSymbolicLink(
                Files.createDirectory(folder.resolve("bin")).resolve("rsal"), Path.of("../a release/rsal"));
        assertThat(run(link, Map.of(), "list").out()).startsWith("@" + top + "/lib/java.options");
    }

    @Test
    void keepsItsCacheElsewhereWhereTheFolderIsReadOnly() throws Exception {
        Files.writeString(top.resolve("cache"), "no folder"); // what root can't write to, either
        Path home = Files.createDirectory(folder.resolve("home"));
        assertThat(run(top.resolve("rsal"), Map.of("HOME", home.toString())).out())
                .anyMatch(line -> line.startsWith("-Drsal.cache=" + home + "/.cache/rsal/start-"));
        assertThat(run(top.resolve("rsal"), Map.of("RSAL_CACHE", folder + "/own"))
                        .out())
                .anyMatch(line -> line.startsWith("-Drsal.cache=" + folder + "/own/start-"));
    }

    @Test
    void doesWithoutACacheWhereNoFolderCanBeWritten() throws Exception {
        Files.writeString(top.resolve("cache"), "no folder");
        Path file = Files.writeString(folder.resolve("file"), "no folder");
        for (Map<String, String> environment :
                List.of(Map.of("HOME", file.toString()), Map.<String, String>of(), Map.of("RSAL_CACHE", "off"))) {
            Result result = run(top.resolve("rsal"), environment, "list");
            assertThat(result.out())
                    .noneMatch(line -> line.contains("AOTCache"))
                    .contains("list");
        }
    }

    @Test
    void withoutARuntimeItTakesTheMachinesIfThatIsNewEnough() throws Exception {
        Files.delete(top.resolve("runtime/bin/java"));
        Path home = folder.resolve("jdk");
        program(home.resolve("bin/java"), JAVA.formatted("25"));
        assertThat(run(top.resolve("rsal"), Map.of("JAVA_HOME", home.toString()), "list")
                        .out())
                .endsWith("rsal.cli.Main", "list");

        program(home.resolve("bin/java"), JAVA.formatted("21"));
        Result result = run(top.resolve("rsal"), Map.of("JAVA_HOME", home.toString()), "list");
        assertThat(result.code()).isEqualTo(5);
        assertThat(result.out())
                .first()
                .asString()
                .isEqualTo("rsal: This release has no Java runtime, and '%s/bin/java' is not Java 25 or newer."
                        .formatted(home));
    }

    @Test
    void saysThatMarksOfProgramsWereLost() throws Exception {
        assertThat(top.resolve("runtime/bin/java").toFile().setExecutable(false, false))
                .isTrue();
        assumeFalse(Files.isExecutable(top.resolve("runtime/bin/java")));
        Result result = run(top.resolve("rsal"), Map.of(), "list");
        assertThat(result.code()).isEqualTo(5);
        assertThat(result.out()).singleElement().asString().contains("can't be executed");
    }

    @Test
    void saysThatAColonIsInTheWay() throws Exception {
        Path moved = Files.move(top, folder.resolve("a:b"));
        Result result = run(moved.resolve("rsal"), Map.of(), "list");
        assertThat(result.code()).isEqualTo(5);
        assertThat(result.out()).singleElement().asString().contains("the colon in it");
    }
}
