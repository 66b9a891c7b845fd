package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.tuple;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunEvent;

class HealthLinesTest {
    private final HealthLines lines = new HealthLines();
    private long sequence;

    private RunEvent event(int millis, String device, String words) {
        return new RunEvent(++sequence, Duration.ofMillis(millis), "health", device, words);
    }

    private boolean tells(int millis, String words) {
        return lines.tells(event(millis, "hunter-1/laser", words));
    }

    @Test
    void reportsAtOnceThatADeviceFailsAndWorksAgain() {
        assertThat(tells(1_000, "is stale: no scan")).isTrue();
        assertThat(tells(1_200, "works")).isTrue();
        assertThat(lines.due(Duration.ofSeconds(60))).isEmpty();
        assertThat(lines.rest()).isEmpty();
    }

    @Test
    void holdsMoreOfThemUntilTenSecondsHavePassed() {
        tells(1_000, "is stale: no scan");
        tells(1_200, "works");
        for (int i = 0; i < 5; i++) {
            assertThat(tells(2_000 + i * 500, "is stale: no scan")).isFalse();
            assertThat(tells(2_200 + i * 500, "works")).isFalse();
        }
        assertThat(lines.due(Duration.ofMillis(10_900))).isEmpty();
        assertThat(lines.due(Duration.ofSeconds(11)))
                .extracting(RunEvent::subject, RunEvent::text)
                .containsExactly(tuple("hunter-1/laser", "works. Its health has changed 10 times since 1.0 s"));
        assertThat(lines.due(Duration.ofSeconds(60))).isEmpty();
    }

    @Test
    void reportsAtOnceWhatChangesAfterAQuietTime() {
        tells(1_000, "is stale: no scan");
        tells(1_200, "works");
        assertThat(tells(11_200, "is stale: no scan")).isTrue();
        assertThat(tells(11_300, "works")).isTrue();
        assertThat(tells(11_400, "is stale: no scan")).isFalse();
    }

    @Test
    void eachDeviceHasItsOwn() {
        tells(1_000, "is stale: no scan");
        tells(1_200, "works");
        assertThat(lines.tells(event(1_300, "hunter-2/laser", "is stale: no scan")))
                .isTrue();
    }

    @Test
    void theEndReportsWhatIsStillHeld() {
        tells(1_000, "is stale: no scan");
        tells(1_200, "works");
        tells(1_300, "is stale: no scan");
        assertThat(lines.rest())
                .extracting(RunEvent::text)
                .containsExactly("is stale: no scan. Its health has changed once more since 1.0 s");
    }
}
