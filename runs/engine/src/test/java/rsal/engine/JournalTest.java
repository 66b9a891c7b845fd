package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;

class JournalTest {
    private final Journal journal = new Journal(() -> Duration.ZERO, () -> {});

    @Test
    void keepsAnEmergencyStopHoweverMuchWasDrivenBefore() {
        for (int each = 0; each < 2 * Journal.MOST_EVENTS; each++) {
            journal.event("hand", "r1", "0.1 m/s");
        }
        journal.event("operator", "", "emergency stop");
        assertThat(journal.after(Journal.MOST_EVENTS - 1))
                .extracting(RunEvent::kind, RunEvent::text)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple("run", "Too many events: of some kinds no more are kept."),
                        org.assertj.core.groups.Tuple.tuple("operator", "emergency stop"));
    }

    @Test
    void saysWhoOrderedWhatPeopleDid() {
        journal.by("Ann", () -> {
            journal.event("operator", "r1", "motors off");
            journal.event("goal", "r1", "given up"); // which comes of it
            return "";
        });
        journal.event("operator", "r1", "motors on");
        assertThat(journal.after(0))
                .extracting(RunEvent::text)
                .containsExactly("motors off (by Ann)", "given up", "motors on");
    }

    @Test
    void keepsNoMoreThanItHasRoomFor() {
        for (int each = 0; each < 2 * (Journal.MOST_EVENTS + Journal.RESERVE); each++) {
            journal.event("operator", "", "emergency stop");
        }
        assertThat(journal.after(0)).hasSize(Journal.MOST_EVENTS + Journal.RESERVE);
    }
}
