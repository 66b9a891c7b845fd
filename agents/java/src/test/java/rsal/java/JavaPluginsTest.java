package rsal.java;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.function.Supplier;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;

class JavaPluginsTest {
    private static final String PLUGIN = """
            public class Plug implements java.util.function.Supplier<String> {
                public String get() { return "made"; }
            }
            """;

    @TempDir
    private Path folder;

    private Supplier<?> read(String text) throws IOException {
        Files.writeString(folder.resolve("Plug.java"), text);
        return new JavaPlugins()
                .read(
                        Supplier.class,
                        "supplier",
                        "Plug.java",
                        FileSource.folder(folder),
                        Location.of(folder.resolve("scenario.yaml").toString()));
    }

    private void refuses(String text, String message, String remedy) {
        assertThatThrownBy(() -> read(text)).isInstanceOfSatisfying(InvalidSettings.class, e -> {
            assertThat(e.problems()).singleElement().satisfies(problem -> {
                assertThat(problem.message()).isEqualTo(message);
                assertThat(problem.remedy()).isEqualTo(remedy);
            });
        });
    }

    @Test
    void makesWhatTheFileSays() throws IOException {
        assertThat(read(PLUGIN).get()).isEqualTo("made");
        assertThat(read(PLUGIN.replace("made", "changed")).get()).isEqualTo("changed");
    }

    @Test
    void saysWhatItMustBe() {
        refuses(
                PLUGIN.replace("function.Supplier<String>", "concurrent.Callable<String>")
                        .replace("get()", "call()"),
                "Class 'Plug' is not of the kind 'supplier'.",
                "Let it implement java.util.function.Supplier.");
        refuses(
                PLUGIN.replace("public class", "class"),
                "Class 'Plug' can't be used as a supplier.",
                "Make it public, not abstract, and give it a public constructor without parameters.");
        refuses(
                PLUGIN.replace(
                        "{\n    public",
                        "{\n    public Plug() { throw new IllegalStateException(\"no\"); }\n    public"),
                "Class 'Plug' fails: java.lang.IllegalStateException: no.",
                "");
    }

    @Test
    void knowsOfWhichKindAClassIsWithoutRunningIt() throws IOException {
        Files.writeString(
                folder.resolve("Plug.java"),
                PLUGIN.replace("{\n    public", "{\n    static { System.exit(1); }\n    public"));
        var language = new JavaPlugins();
        var files = FileSource.folder(folder);
        var at = Location.of(folder.resolve("Plug.java").toString());
        assertThat(language.isOf(Supplier.class, "Plug.java", files, at)).isTrue();
        assertThat(language.isOf(Runnable.class, "Plug.java", files, at)).isFalse();
        Files.writeString(folder.resolve("Plug.java"), "class Other {}");
        assertThat(language.isOf(Supplier.class, "Plug.java", files, at)).isFalse();
        Files.writeString(folder.resolve("Plug.java"), "class Plug {");
        assertThatThrownBy(() -> language.isOf(Supplier.class, "Plug.java", files, at))
                .isInstanceOf(InvalidSettings.class);
    }
}
