package rsal.engine.event;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunEvent;

class EventLogTest {
    private final EventLog eventLog = new EventLog(() -> Duration.ZERO, () -> {});

    @Test
    void keepsAnEmergencyStopHoweverMuchWasDrivenBefore() {
        for (int each = 0; each < 2 * EventLog.MOST_EVENTS; each++) {
            eventLog.event("hand", "r1", "0.1 m/s");
        }
        eventLog.event("operator", "", "emergency stop");
        assertThat(eventLog.after(EventLog.MOST_EVENTS - 1))
                .extracting(RunEvent::kind, RunEvent::text)
                .containsExactly(
                        org.assertj.core.groups.Tuple.tuple("run", "Too many events: of some kinds no more are kept."),
                        org.assertj.core.groups.Tuple.tuple("operator", "emergency stop"));
    }

    @Test
    void saysWhoOrderedWhatPeopleDid() {
        eventLog.by("Ann", () -> {
            eventLog.event("operator", "r1", "motors off");
            eventLog.event("goal", "r1", "given up"); // which comes of it
            return "";
        });
        eventLog.event("operator", "r1", "motors on");
        assertThat(eventLog.after(0))
                .extracting(RunEvent::text)
                .containsExactly("motors off (by Ann)", "given up", "motors on");
    }

    @Test
    void keepsNoMoreThanItHasRoomFor() {
        for (int each = 0; each < 2 * (EventLog.MOST_EVENTS + EventLog.RESERVE); each++) {
            eventLog.event("operator", "", "emergency stop");
        }
        assertThat(eventLog.after(0)).hasSize(EventLog.MOST_EVENTS + EventLog.RESERVE);
    }
}
