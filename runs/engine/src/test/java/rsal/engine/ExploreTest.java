package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.io.TempDir;
import rsal.data.OccupancyGrid;
import rsal.engine.report.RunResult;
import rsal.map.RosMap;
import rsal.scenario.RunOptions;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;

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

    private static final String ROOM = """
            rsal: 1
            scenario: room
            title: A robot maps a room
            world: {map: room.yaml}
            robots:
              scout:
                model: pioneer2dx
                pose: [1.5, 1.5, 0]
                devices: {laser: urg04lx, localizer: {type: slam}, navigator: {}, explorer: {}}
            run:
              seed: 1
              stop:
                - {when: exploring(scout) == 0 and explored >= 0.95, outcome: success}
                - {when: time > 200, outcome: timeout}
            metrics:
              - {name: explored, from: explored, better: more, bound: {min: 0.95}}
              - {name: mapped, unit: s, from: firstTime(exploring(scout) == 0), better: less}
            """;

    @TempDir
    private Path folder;

    @Test
    @LongTest
    void aRobotThatHasMappedAllSaysSoAndEndsTheRun() throws IOException {
        OccupancyGrid room = DrawnMap.grid(0.5, """
                ################
                #..............#
                #..............#
                #......##......#
                #......##......#
                #......##......#
                #......##......#
                ################
                """).grid();
        Files.write(folder.resolve("room.pgm"), RosMap.pgm(room));
        Files.writeString(folder.resolve("room.yaml"), RosMap.yaml(room, "room.pgm"));
        try (var run = LiveRun.start(Runs.plan(folder, ROOM, RunOptions.NONE))) {
            RunResult result = Runs.result(run);
            assertThat(result.outcome()).isEqualTo("success");
            assertThat(result.metrics().get("explored").orElseThrow()).isBetween(0.95, 1.0);
            assertThat(result.metrics().get("mapped").orElseThrow()).isPositive();
            assertThat(run.events(0))
                    .anyMatch(event ->
                            event.kind().equals("mapped") && event.subject().equals("scout"));
        }
    }

    @Test
    @LongTest
    void aMapThatLiesNobodyKnowsHowHasNoErrorAndNoShare() {
        String anywhere = TWO_EXPLORERS.replaceAll("\\s+pose: .*", "") + """
                metrics:
                  - {name: error, from: p50(poseError), per: robot}
                  - {name: explored, from: explored}
                """;
        try (var run = LiveRun.start(Runs.plan(folder, anywhere, RunOptions.NONE))) {
            RunResult result = Runs.result(run);
            assertThat(result.metrics())
                    .hasSize(3)
                    .allSatisfy((name, value) -> assertThat(value).as(name).isEmpty());
        }
    }

    @Test
    @LongTest
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
