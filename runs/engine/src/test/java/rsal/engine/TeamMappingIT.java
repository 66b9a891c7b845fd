package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Path;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

/// A team to which it is given as a task to map a place, as in `swarm:mapping`, in four rooms.
@Timeout(300)
class TeamMappingIT {
    private static final String ROOMS = """
            rsal: 1
            scenario: rooms
            world: {map: four-rooms}
            robots:
              robot:
                count: 3
                model: pioneer2dx
                pose: [[-3, 2, 0], [3.5, -2, 90], [-3, -2.5, 0]]
                devices:
                  laser: urg04lx
                  localizer: {type: slam}
                  navigator: {}
                  explorer: {mapOnly: true, maxRange: 3}
                  planner: {type: explored}
            agents:
              worker: {type: worker, robot: robot}
              mapping: {type: mapping}
            run:
              clock: {speed: max}
              stop:
                - {when: exploring(robot) == 0 and explored >= 0.97, outcome: success}
                - {when: time > 400, outcome: timeout}
            metrics:
              - {name: explored, from: explored}
              - {name: collisions, from: count(collisions)}
            """;
    private static final String FAULTS = """
            faults:
              - {kind: gone, robots: robot, pick: 1, at: 20}
              - {kind: lost, share: 0.2}
            """;

    @TempDir
    private Path folder;

    private void assertMapped(String scenario, long seed) {
        RunResult result = Runs.result(Runs.plan(folder, scenario, RunOptions.NONE.withSeed(seed)));
        assertThat(result.outcome()).as("seed %d: %s", seed, result).isEqualTo("success");
        assertThat(result.metrics().get("collisions").getAsDouble())
                .as("seed %d", seed)
                .isZero();
    }

    @Trials({"1", "2", "3"})
    void mapsAll(long seed) {
        assertMapped(ROOMS, seed);
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void mapsAllWhenOneIsTakenAwayAndMessagesAreLost(long seed) {
        assertMapped(ROOMS + FAULTS, seed);
    }
}
