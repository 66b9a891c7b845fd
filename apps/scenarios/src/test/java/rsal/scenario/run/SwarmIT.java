package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

@Timeout(300)
class SwarmIT {
    private static final Scenario SWARM = Scenario.load("swarm");

    private static RunResult run(String configuration, long seed, double seconds, int helpers) {
        var options = RunOptions.NONE
                .withConfiguration(configuration)
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withLimit(Duration.ofMillis(Math.round(seconds * 1000)));
        try (var run = LiveRun.start(SWARM.plan(options), helpers)) {
            return run.result()
                    .toCompletableFuture()
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
        }
    }

    private static double measure(RunResult result, String name) {
        return result.measures().get(name).getAsDouble();
    }

    @Test
    void tenSpreadOutAlongTheWallsAndKnowWhereTheyAre() {
        for (long seed = 1; seed <= 3; seed++) {
            RunResult result = run("ten", seed, 40, 1);
            assertThat(measure(result, "distance")).as("seed %d", seed).isGreaterThan(10 * 10);
            assertThat(measure(result, "localizationError")).as("seed %d", seed).isLessThan(0.35);
            assertThat(measure(result, "collisions")).as("seed %d", seed).isZero();
            assertThat(measure(result, "heardMessages")).isEqualTo(9 * measure(result, "messages"));
        }
    }

    @Test
    void aHundredDoTheSameOnOneCoreAndMore() {
        RunResult alone = run("hundred", 1, 3, 1);
        assertThat(run("hundred", 1, 3, 3).eventHash()).isEqualTo(alone.eventHash());
        assertThat(measure(alone, "collisions")).isZero();
    }

    @Test
    void aThousandBegin() {
        RunResult result = run("thousand", 1, 1, 1);
        assertThat(measure(result, "messages")).isEqualTo(3000); // a greeting each, and where they are
        assertThat(measure(result, "heardMessages")).isEqualTo(999 * 3000);
        assertThat(measure(result, "distance")).isGreaterThan(50);
        assertThat(measure(result, "wallCollisions")).isZero();
    }
}
