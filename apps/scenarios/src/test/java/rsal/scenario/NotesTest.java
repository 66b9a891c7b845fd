package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.settings.Problem;

class NotesTest {
    @TempDir
    private Path folder;

    private String world(String text) throws IOException {
        return Files.writeString(folder.resolve("some.world.yaml"), text).toString();
    }

    @Test
    void aWorldWithNothingInItIsToldOfWhenItIsReadOrRun() throws IOException {
        String empty = world("rsal: 1\n");
        assertThat(Scenario.scene(empty).warnings())
                .extracting(Problem::message)
                .containsExactly("There is nothing in this world: no wall, no thing, no robot.");
        assertThat(Scenario.load(empty).plan(RunOptions.NONE).notes())
                .isEqualTo(Scenario.scene(empty).warnings());
    }

    @Test
    void aWorldWithoutRobotsIsToldOfOnlyWhenItIsRun() throws IOException {
        String still = world("rsal: 1\nwalls: [{radius: 1, center: [0, 0]}]\n");
        assertThat(Scenario.scene(still).warnings()).isEmpty();
        assertThat(Scenario.load(still).plan(RunOptions.NONE).notes())
                .extracting(Problem::message)
                .containsExactly("There is no robot in this world, so that nothing moves.");
        String moving = world("rsal: 1\nrobots: {r: {model: pioneer2dx, pose: [0, 0, 0]}}\n");
        assertThat(Scenario.scene(moving).warnings()).isEmpty();
        assertThat(Scenario.load(moving).plan(RunOptions.NONE).notes()).isEmpty();
    }

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
