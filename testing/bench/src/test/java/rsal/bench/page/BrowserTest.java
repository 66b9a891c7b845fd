package rsal.bench.page;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.net.URI;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;

class BrowserTest {
    @Test
    void runsWhatPagesBeginWithAndAnswersInNumbers() throws IOException {
        Optional<Path> program = Browser.find();
        assumeTrue(program.isPresent(), "There is no Chromium here.");
        long before = ProcessHandle.current().descendants().count();
        Set<Path> profiles = profiles();
        try (var browser = Browser.start(program.get())) {
            browser.begin("globalThis.begun = (globalThis.begun ?? 0) + 1;");
            browser.open(URI.create("data:text/html,Here"));
            assertThat(browser.number("begun")).isEqualTo(1);
            assertThat(browser.number("innerWidth")).isEqualTo(1366);
            assertThat(browser.heap()).isPositive();
            assertThatIllegalStateException()
                    .isThrownBy(() -> browser.open(URI.create("nothing")))
                    .withMessageContaining("Page.navigate");
        }
        assertThat(ProcessHandle.current()
                        .descendants()
                        .filter(ProcessHandle::isAlive)
                        .count())
                .isLessThanOrEqualTo(before);
        assertThat(profiles()).isSubsetOf(profiles);
    }

    @Test
    void leavesNothingOfAProgramThatIsNoBrowser() throws IOException {
        Set<Path> profiles = profiles();
        assertThatIllegalStateException()
                .isThrownBy(() -> Browser.start(Path.of("/bin/true")))
                .withMessageContaining("/bin/true");
        assertThat(profiles()).isSubsetOf(profiles);
    }

    private static Set<Path> profiles() throws IOException {
        try (Stream<Path> files = Files.list(Path.of(System.getProperty("java.io.tmpdir")))) {
            return files.filter(file -> file.getFileName().toString().startsWith("rsal-browser-"))
                    .collect(Collectors.toSet());
        }
    }
}
