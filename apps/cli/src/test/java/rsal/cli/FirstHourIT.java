package rsal.cli;

import static org.assertj.core.api.Assertions.assertThat;
import static org.junit.platform.engine.discovery.DiscoverySelectors.selectClass;

import java.io.IOException;
import java.net.URL;
import java.net.URLClassLoader;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.regex.Pattern;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.platform.launcher.core.LauncherDiscoveryRequestBuilder;
import org.junit.platform.launcher.core.LauncherFactory;
import org.junit.platform.launcher.listeners.SummaryGeneratingListener;
import org.junit.platform.launcher.listeners.TestExecutionSummary;
import rsal.testkit.LongTest;

/// Does what the first hour says: writes its files, compiles them, runs their tests, types its commands. Only Maven is
/// left out, which would build all of RSAL again.
class FirstHourIT {
    private static final Path PAGE = Path.of("../../docs/first-hour.md");

    private static final Pattern TEST =
            Pattern.compile("(?m)^\\$ ./mvnw -Dfast -pl agents/own -am test -Dtest=(\\w+)$");

    @TempDir
    Path folder;

    private String page = "";
    private OwnFolder own = OwnFolder.NONE;

    @BeforeEach
    void writeWhatItSays() throws IOException {
        page = Files.readString(PAGE);
        own = OwnFolder.of(page, folder);
    }

    @Test
    void itsCommandsShowWhatItSays() throws Exception {
        TutorialIT.follow(
                TEST.matcher(page).replaceAll("\\$ ./rsal list"),
                new Rsal(folder, own.classes().toString()));
    }

    @Test
    @LongTest
    void itsTestsPass() throws Exception {
        own.compile("test", own.classes() + ":" + System.getProperty("java.class.path"));
        List<String> named =
                TEST.matcher(page).results().map(test -> test.group(1)).toList();
        assertThat(named).hasSize(2);
        URL[] classes = {own.classes().toUri().toURL()};
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
