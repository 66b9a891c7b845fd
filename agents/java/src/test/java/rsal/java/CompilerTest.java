package rsal.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.catchThrowableOfType;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import javax.tools.JavaCompiler;
import javax.tools.ToolProvider;
import org.eclipse.jdt.internal.compiler.tool.EclipseCompiler;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.Parameter;
import org.junit.jupiter.params.ParameterizedClass;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

/// The JDK's compiler, and Eclipse's, which takes its place in a Java runtime without one.
@ParameterizedClass
@MethodSource("compilers")
class CompilerTest {
    @Parameter
    private JavaCompiler compiler;

    @TempDir
    private Path folder;

    static List<JavaCompiler> compilers() {
        return List.of(ToolProvider.getSystemJavaCompiler(), new EclipseCompiler());
    }

    private Map<String, byte[]> compile(String text) throws IOException {
        Files.writeString(folder.resolve("Mine.java"), text);
        return Compiler.compile(
                Sources.read("Mine.java", FileSource.folder(folder), Location.of("scenario.yaml")), compiler);
    }

    @Test
    void makesClassesOfThisJavaFromItsNewestLanguage() throws IOException {
        Map<String, byte[]> classes = compile("""
                import rsal.agent.*;

                public class Mine implements Agent {
                    sealed interface Task permits Carry {}
                    record Carry(double mass) implements Task {}
                    public void start(AgentContext self) {
                        Task task = new Carry(2);
                        switch (task) { case Carry(double mass) when mass > 1 -> {} case Carry _ -> {} }
                    }
                }
                """);
        assertThat(classes).containsOnlyKeys("Mine", "Mine$Task", "Mine$Carry");
        assertThat(classes.get("Mine")[7])
                .isEqualTo((byte) (44 + Runtime.version().feature()));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', textBlock = """
            Load load;           | 5 | Maybe an import is missing, or a file 'Load.java' beside it.
            int x = "y";         | 5 | ''
            self.reportAll();   | 5 | ''
            """)
    void reportsEachErrorWithItsPlaceAndARemedy(String statement, int line, String remedy) {
        InvalidSettings errors = catchThrowableOfType(InvalidSettings.class, () -> compile("""
                import rsal.agent.*;

                public class Mine implements Agent {
                    public void start(AgentContext self) {
                        %s
                    }
                }
                """.formatted(statement)));
        assertThat(errors.problems()).singleElement().satisfies(problem -> {
            assertThat(problem.location().file()).isEqualTo("Mine.java");
            assertThat(problem.location().line()).isEqualTo(line);
            assertThat(problem.message())
                    .startsWith("Java can't compile this: ")
                    .endsWith(".");
            assertThat(problem.remedy()).isEqualTo(remedy);
        });
    }

    @Test
    void packagesAreKept() throws IOException {
        assertThat(compile("package lab.hunt; public class Mine { static class Inner {} }"))
                .containsOnlyKeys("lab.hunt.Mine", "lab.hunt.Mine$Inner");
    }

    @Test
    void anErrorInAFileThatItNeedsIsReportedThere() throws IOException {
        Files.writeString(folder.resolve("Load.java"), "public record Load(dubble mass) {}");
        InvalidSettings errors =
                catchThrowableOfType(InvalidSettings.class, () -> compile("public class Mine { Load load; }"));
        assertThat(errors.problems())
                .extracting(error -> error.location().toString())
                .containsExactly("Load.java:1:20");
    }

    @Test
    void writesNoFile() throws IOException {
        compile("public class Mine {}");
        try (var files = Files.list(folder)) {
            assertThat(files).containsExactly(folder.resolve("Mine.java"));
        }
    }
}
