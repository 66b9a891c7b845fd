package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import javax.tools.ToolProvider;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import org.junit.platform.launcher.listeners.TestExecutionSummary;

/// Does what the first hour says: writes its files, compiles them, runs their tests, types its commands. Only Maven is
/// left out, which would build all of RSAL again.
class FirstHourIT {
    private static final Path PAGE = Path.of("../../docs/first-hour.md");

    /// A file's name, the rest of the sentence, and what is in it.
    private static final Pattern FILE =
            Pattern.compile("`(agents/own/[^`]+|\\w+\\.yaml)`[^`]*:\n\n```\\w*\n(.*?)```", Pattern.DOTALL);

    private static final Pattern TEST =
            Pattern.compile("(?m)^\\$ ./mvnw -Dfast -pl agents/own -am test -Dtest=(\\w+)$");

    @TempDir
    Path folder;

    private String page = "";

    @BeforeEach
    void writeWhatItSays() throws IOException {
        page = Files.readString(PAGE);
        var files = new LinkedHashMap<String, String>();
        FILE.matcher(page).results().forEach(file -> files.put(file.group(1), file.group(2)));
        assertThat(files.values())
                .containsAll(TutorialIT.blocks(page, "java"))
                .containsAll(TutorialIT.blocks(page, "yaml"));
        for (Map.Entry<String, String> file : files.entrySet()) {
            Path path = folder.resolve(file.getKey());
            Files.createDirectories(path.getParent());
            Files.writeString(path, file.getValue());
        }
        compile("main", Rsal.classPath());
        Path services = folder.resolve("classes/META-INF");
        Files.move(folder.resolve("agents/own/src/main/resources/META-INF"), services);
    }

    @Test
    void itsCommandsShowWhatItSays() throws Exception {
        TutorialIT.follow(
                TEST.matcher(page).replaceAll("\\$ ./rsal list"),
                new Rsal(folder, folder.resolve("classes").toString()));
    }

    @Test
    void itsTestsPass() throws Exception {
        compile("test", folder.resolve("classes") + ":" + System.getProperty("java.class.path"));
        List<String> named =
                TEST.matcher(page).results().map(test -> test.group(1)).toList();
        assertThat(named).hasSize(2);
        URL[] classes = {folder.resolve("classes").toUri().toURL()};
        try (var loader = new URLClassLoader(classes, getClass().getClassLoader())) {
            for (String test : named) {
                TestExecutionSummary summary = run(loader.loadClass("own." + test));
                assertThat(summary.getFailures()).isEmpty();
                assertThat(summary.getTestsSucceededCount()).isPositive();
                if (test.equals("SimThermometerTest")) {
                    assertThat(page).contains("`Tests run: %d`".formatted(summary.getTestsSucceededCount()));
                }
            }
        }
    }

    private void compile(String sources, String classPath) throws IOException {
        var command = new ArrayList<>(List.of("-d", folder.resolve("classes").toString(), "-cp", classPath));
        try (Stream<Path> files = Files.list(folder.resolve("agents/own/src/%s/java/own".formatted(sources)))) {
            files.map(Path::toString).sorted().forEach(command::add);
        }
        assertThat(ToolProvider.getSystemJavaCompiler().run(null, null, null, command.toArray(String[]::new)))
                .isZero();
    }

    private static TestExecutionSummary run(Class<?> test) {
        var summary = new SummaryGeneratingListener();
        LauncherFactory.create()
                .execute(
                        LauncherDiscoveryRequestBuilder.request()
                                .selectors(selectClass(test))
                                .build(),
                        summary);
        return summary.getSummary();
    }
}
