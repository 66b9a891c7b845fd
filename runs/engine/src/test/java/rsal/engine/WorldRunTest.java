package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.Pose2d;
import rsal.scenario.RunOptions;
import rsal.scenario.RunPlan;
import rsal.scenario.Scenario;

/// A run of a world with all that is in it, and what a Player configuration has its servers make of robots.
class WorldRunTest {
    private static final String HALL = """
            define cart position ( size [0.4 0.3 0.2] ranger ( sensor ( range [0 4] fov 180 samples 37 ) ) )
            model ( name "walls" size [10 10 1] boundary 1 )
            cart ( name "r0" pose [-2 0 0 0] ctrl "wander" )
            """;
    private static final String SERVED = """
            driver ( name "stage" plugin "stageplugin" provides ["simulation:0"] worldfile "hall.world" )
            driver ( name "stage" provides ["position2d:0" "ranger:0"] model "r0" )
            driver ( name "rangertolaser" requires ["ranger:0"] provides ["laser:0"] )
            driver ( name "amcl" requires ["position2d:0" "laser:0"] provides ["localize:0"]
                     init_pose [1.5 0.5 90] init_pose_var [0.01 0.01 1] )
            """;

    @TempDir
    private Path folder;

    @Test
    @Timeout(60)
    void aLocalizerBelievesAtFirstWhatItsFileSays() throws IOException {
        Files.writeString(folder.resolve("hall.world"), HALL);
        Path file = Files.writeString(folder.resolve("hall.cfg"), SERVED);
        RunPlan plan = Scenario.load(file.toString()).plan(RunOptions.NONE);
        Pose2d wrong = Pose2d.ofDegrees(1.5, 0.5, 90);
        assertThat(plan.robots().getFirst().spec().mapFromBase().orElseThrow().distanceTo(wrong))
                .isGreaterThan(0.5);
        try (var run = LiveRun.start(plan)) {
            Optional<Pose2d> believed = Optional.empty();
            while (believed.isEmpty()) {
                believed = run.snapshot().robots().stream()
                        .flatMap(robot -> robot.estimate().stream())
                        .map(estimate -> estimate.value().mapFromBase())
                        .findFirst();
            }
            assertThat(believed.get().isNear(wrong, 0.1, 0.1)).isTrue();
        }
    }
}
