package rsal.bench;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalStateException;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.net.URI;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;

class BrowserTest {
    @Test
    void runsWhatPagesBeginWithAndAnswersInNumbers() {
        Optional<Path> program = Browser.find();
        assumeTrue(program.isPresent(), "There is no Chromium here.");
        long before = ProcessHandle.current().descendants().count();
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
    }
}
