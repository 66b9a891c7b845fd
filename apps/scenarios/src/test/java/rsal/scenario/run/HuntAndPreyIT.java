package rsal.scenario.run;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

@Timeout(300)
class HuntAndPreyIT {
    private static final Scenario HUNT = Scenario.load("hunt-and-prey");

    private record Hunt(RunResult result, List<RunEvent> events) {}

    private static Hunt hunt(String configuration, long seed) {
        return hunt(configuration, seed, 1);
    }

    private static Hunt hunt(String configuration, long seed, int helpers) {
        var options =
                RunOptions.NONE.withConfiguration(configuration).withSeed(seed).withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(HUNT.plan(options), helpers)) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(60, TimeUnit.SECONDS)
                    .join();
            return new Hunt(result, run.events(0));
        }
    }

    @Test
    void thePreyIsCaughtInNineOfTenHunts() {
        var caught = new ArrayList<Long>();
        for (long seed = 1; seed <= 10; seed++) {
            Hunt hunt = hunt("virtual", seed);
            if (hunt.result.outcome().equals("success")) {
                caught.add(seed);
            }
            assertThat(hunt.result.measures().get("wallCollisions").getAsDouble())
                    .as("seed %d", seed)
                    .isZero();
            hunt.result.measures().forEach((name, value) -> {
                if (name.startsWith("localizationError.")) {
                    assertThat(value.getAsDouble())
                            .as("%s, seed %d", name, hunt.result.seed())
                            .isLessThanOrEqualTo(0.30);
                }
            });
        }
        assertThat(caught).hasSizeGreaterThanOrEqualTo(9);
    }

    @Test
    void theSameSeedIsTheSameHuntHoweverManyHelp() {
        Hunt first = hunt("virtual", 3, 1);
        Hunt second = hunt("virtual", 3, 4);
        assertThat(second.events).isEqualTo(first.events);
        assertThat(second.result.eventHash()).isEqualTo(first.result.eventHash());
    }

    @Test
    void aBehaviorIsInChargeOfThePreyAndANavigatorOfTheHunters() {
        var options =
                RunOptions.NONE.withSeed(3).withSpeed(Double.POSITIVE_INFINITY).withLimit(Duration.ofSeconds(10));
        try (var run = LiveRun.start(HUNT.plan(options))) {
            Runs.result(run);
            assertThat(run.snapshot().robots())
                    .extracting(RobotView::inCharge)
                    .satisfiesExactly(
                            prey -> assertThat(prey).isNotEmpty().isNotEqualTo("navigator"),
                            hunter -> assertThat(hunter).isEqualTo("navigator"),
                            hunter -> assertThat(hunter).isEqualTo("navigator"));
        }
    }

    @Test
    void fourHuntersCatchThreePreyOneByOne() {
        Hunt hunt = hunt("advanced", 2);
        assertThat(hunt.result.outcome()).isEqualTo("success");
        assertThat(hunt.events)
                .filteredOn(event -> event.kind().equals("caught"))
                .extracting(RunEvent::subject)
                .containsExactlyInAnyOrder("escape-1", "escape-2", "escape-3");
    }
}
