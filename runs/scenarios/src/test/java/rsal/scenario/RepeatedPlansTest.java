package rsal.scenario;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/// What the plans of one scenario share, so that what depends on a map is computed once.
class RepeatedPlansTest {
    @TempDir
    Path folder;

    @Test
    void haveTheSameMapAndTheSameRobotSystem() throws IOException {
        Scenario scenario = scenario();
        RunPlan first = scenario.plan(RunOptions.NONE.withSeed(1));
        RunPlan second = scenario.plan(RunOptions.NONE.withSeed(2));
        assertThat(second.scene().map().cells()).isSameAs(first.scene().map().cells());
        assertThat(second.mrs().provider()).isSameAs(first.mrs().provider());
    }

    @Test
    void readAMapAgainThatWasWrittenTo() throws IOException {
        Scenario scenario = scenario();
        RunPlan first = scenario.plan(RunOptions.NONE);
        draw("255");
        RunPlan second = scenario.plan(RunOptions.NONE);
        assertThat(first.scene().map().cells()[0]).isEqualTo((byte) 100);
        assertThat(second.scene().map().cells()[0]).isEqualTo((byte) 0);
    }

    private Scenario scenario() throws IOException {
        draw("0");
        Files.writeString(folder.resolve("lab.yaml"), """
                image: lab.pgm
                resolution: 1
                origin: [0, 0, 0]
                negate: 0
                occupied_thresh: 0.65
                free_thresh: 0.196
                """);
        Path file = folder.resolve("again.yaml");
        Files.writeString(file, """
                rsal: 1
                scenario: again
                world: {map: lab.yaml}
                robots:
                  one: {model: pioneer2dx, pose: [5, 5, 0]}
                """);
        return Scenario.load(file.toString());
    }

    /// A room of 8 m × 8 m, of which one pixel is drawn.
    private void draw(String lowerLeft) throws IOException {
        var image = new StringBuilder("P2 8 8 255\n");
        for (int pixel = 0; pixel < 64; pixel++) {
            image.append(pixel == 56 ? lowerLeft : "255").append('\n');
        }
        Files.writeString(folder.resolve("lab.pgm"), image);
    }
}
