package rsal.cli.terminal;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import rsal.engine.report.RunEvent;

class ProgressTest {
    @Test
    void reportsWhenWhatHappenedToWhom() {
        var time = Duration.ofMillis(12_340);
        assertThat(Progress.line(new RunEvent(1, time, "collision", "hunter-1", "ran into wall", Optional.empty())))
                .isEqualTo("    12.3 s  hunter-1: ran into wall");
        assertThat(Progress.line(new RunEvent(2, time, "operator", "", "emergency stop", Optional.empty())))
                .isEqualTo("    12.3 s  emergency stop");
    }

    @Test
    void reportsRobotsThatDidNotGetWhereTheyWereSent() {
        assertThat(Progress.tells(event("unreached", "can't get to (3.00, 1.00), 0°: stuck")))
                .isTrue();
        assertThat(Progress.tells(event("collision", "ran into wall"))).isTrue();
        assertThat(Progress.tells(event("print", "beat"))).isTrue();
        assertThat(Progress.tells(event("goal", "is at (3.00, 1.00), 0°"))).isFalse();
    }

    @Test
    void aRunThatStandsStillIsCalledPaused() {
        var time = Duration.ofMillis(12_340);
        assertThat(Progress.line(time, true, 0, false)).isEqualTo("    12.3 s  paused");
        assertThat(Progress.line(time, false, 1.5, true)).isEqualTo("    12.3 s  running at 1.50 × real time");
    }

    @Test
    void aRunThatHasNotFoundItsRobotsSaysSo() {
        assertThat(Progress.line(Duration.ZERO, false, 0, true)).isEqualTo("           waiting for robots");
    }

    private static RunEvent event(String kind, String text) {
        return new RunEvent(1, Duration.ofSeconds(1), kind, "robot-1", text, Optional.empty());
    }
}
