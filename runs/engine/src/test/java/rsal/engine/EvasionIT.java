package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

/// Prey that flee, beside prey that only follow walls.
@Timeout(300)
class EvasionIT {
    private static final String SCENARIO = """
            rsal: 1
            scenario: evasion
            title: One prey and one hunter that comes along the corridor
            world: {map: office}
            robots:
              prey:
                model: pioneer2dx
                pose: [2, -1, 0]
                devices: {laser: urg04lx, sonar: front8, localizer: {type: amcl}, navigator: {}, pilot: {}, planner: {type: wavefront}, places: {}}
              hunter:
                model: pioneer3at
                pose: [-8, -1, 0]
                devices: {laser: utm30lx, localizer: {type: amcl}, planner: {type: wavefront}, navigator: {maxSpeed: 0.45}}
            agents:
              prey: {type: evade, robot: prey, parameters: {hunter: hunter, catchDistance: 1.5}}
              hunter: {type: follow, robot: hunter, parameters: {prey: prey, catchDistance: 1.5}}
            run:
              stop:
                - {when: allCaught(prey), outcome: success}
                - {when: time > 300, outcome: timeout}
            metrics:
              - {name: captureTime, unit: s, from: firstTime(allCaught(prey))}
            configurations:
              flees: {title: it flees}
              follows:
                title: it follows the wall
                agents: {prey: {type: escape, robot: prey, parameters: {hunter: hunter, catchDistance: 1.5}}}
            """;

    private static double captureTime(String configuration, long seed) {
        var options =
                RunOptions.NONE.withConfiguration(configuration).withSeed(seed).withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(Scenario.edited("hunt-and-prey", SCENARIO).plan(options))) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(250, TimeUnit.SECONDS)
                    .join();
            assertThat(result.outcome()).isIn("success", "timeout");
            return result.metrics().get("captureTime").orElse(300);
        }
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void preyThatFleeLiveTwiceAsLongAsThoseThatFollowTheWall(long seed) {
        assertThat(captureTime("flees", seed)).isGreaterThan(2 * captureTime("follows", seed));
    }
}
