package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.OccupancyGrid;
import rsal.scenario.RunOptions;

@Timeout(120)
class ExploreTest {
    private static final String TWO_EXPLORERS = """
            rsal: 1
            scenario: two
            title: Two robots map the office
            world: {map: office}
            robots:
              east:
                model: pioneer2dx
                pose: [29, -0.8, 180]
                devices: {laser: urg04lx, localizer: {type: slam}, navigator: {}, explorer: {}}
              west:
                model: pioneer2dx
                pose: [-12, -0.8, 0]
                devices: {laser: urg04lx, localizer: {type: slam}, navigator: {}, explorer: {}}
            run:
              seed: 1
              stop:
                - {when: time > 10, outcome: success}
            """;

    @TempDir
    private Path folder;

    @Test
    void robotsOfARunDrawOneMap() {
        try (var run = LiveRun.start(Runs.plan(folder, TWO_EXPLORERS, RunOptions.NONE))) {
            Runs.result(run);
            assertThat(run.snapshot().robots()).hasSize(2).allSatisfy(robot -> {
                OccupancyGrid map = robot.map().orElseThrow().value();
                assertThat(map.isFree(29, -0.8)).as(robot.id()).isTrue();
                assertThat(map.isFree(-12, -0.8)).as(robot.id()).isTrue();
            });
        }
    }
}
