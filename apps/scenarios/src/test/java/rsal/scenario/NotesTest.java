package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.settings.Problem;

class NotesTest {
    private static RunPlan teleop(String configuration, RunOptions options) {
        return Scenario.load("teleop").plan(options.withConfiguration(configuration));
    }

    @Test
    void aSpeedOfRealTimeIsSaidToBeOne() {
        assertThat(teleop("real", RunOptions.NONE.withSpeed(4)).notes())
                .extracting(Problem::message)
                .anyMatch(note -> note.startsWith("A run in real time goes at speed 1"));
        assertThat(teleop("real", RunOptions.NONE).notes()).isEmpty();
    }
}
