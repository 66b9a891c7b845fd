package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.InstanceOfAssertFactories.DURATION;

import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.stream.Collectors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(300)
class PatrolIT {
    private static final Scenario PATROL = Scenario.load("patrol");

    private record Watch(RunResult result, List<RunEvent> events) {
        double metric(String name) {
            return result.metrics().get(name).getAsDouble();
        }

        /// Those who were at a place after some time.
        Set<String> guards(long after) {
            return guards(after, Long.MAX_VALUE);
        }

        /// Those who were at a place to watch in a part of the time.
        Set<String> guards(long after, long until) {
            return guards(event -> event.text().contains(" was at "), after, until);
        }

        /// Those who got to where they had been sent.
        Set<String> spread(long after, long until) {
            return guards(event -> event.kind().equals("goal") && event.text().endsWith(": reached"), after, until);
        }

        /// Places where somebody was after some time.
        Set<String> places(long after) {
            return events.stream()
                    .filter(event -> event.time().toSeconds() > after)
                    .map(RunEvent::text)
                    .filter(text -> text.startsWith("guard-") && text.contains(" was at "))
                    .map(text -> text.substring(text.indexOf(" was at ")))
                    .collect(Collectors.toSet());
        }

        private Set<String> guards(Predicate<RunEvent> happened, long after, long until) {
            return events.stream()
                    .filter(event -> event.text().startsWith("guard-") && happened.test(event))
                    .filter(event ->
                            event.time().toSeconds() > after && event.time().toSeconds() <= until)
                    .map(event -> event.text().substring(0, "guard-1".length()))
                    .collect(Collectors.toSet());
        }
    }

    private static Watch watch(RunOptions options) {
        try (var run = LiveRun.start(PATROL.plan(options.withSpeed(Double.POSITIVE_INFINITY)))) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(200, TimeUnit.SECONDS)
                    .join();
            return new Watch(result, run.events(0));
        }
    }

    private static Watch watch(String configuration, long seed, long seconds) {
        return watch(
                RunOptions.NONE.withConfiguration(configuration).withSeed(seed).withLimit(Duration.ofSeconds(seconds)));
    }

    @Trials({"1", "2", "3"})
    void noPlaceIsLeftAloneForLong(long seed) {
        Watch watch = watch("virtual", seed, 400);
        assertThat(watch.metric("collisions")).isZero();
        assertThat(watch.metric("meanIdleness")).isLessThan(45);
        assertThat(watch.metric("worstIdleness")).isLessThan(200);
        assertThat(watch.metric("visitGap")).isBetween(50.0, 100.0);
        assertThat(watch.guards(0)).hasSize(4);
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void balancedToursLeavePlacesAloneForAShorterTimeThanBids(long seed) {
        Watch balanced = watch("virtual", seed, 600);
        Watch bids = watch(RunOptions.NONE
                .withArguments(Map.of("strategy", "bids"))
                .withSeed(seed)
                .withLimit(Duration.ofMinutes(10)));
        assertThat(balanced.metric("meanIdleness")).isLessThan(0.85 * bids.metric("meanIdleness"));
        assertThat(balanced.metric("worstIdleness")).isLessThan(bids.metric("worstIdleness"));
    }

    @Trials({"1", "2"})
    @LongTest
    void theOthersDivideThePlacesOfOneThatIsGone(long seed) {
        Watch watch = watch("faulty", seed, 700);
        assertThat(watch.guards(220)).hasSize(3);
        assertThat(watch.places(260)).hasSize(12);
        assertThat(watch.metric("meanIdleness")).isLessThan(75);
    }

    @Trials({"1", "2"})
    @LongTest
    void theOthersTakeOverWhenOneIsGoneAndMessagesAreLost(long seed) {
        Watch watch = watch(RunOptions.NONE
                .withConfiguration("faulty")
                .withArguments(Map.of("strategy", "bids"))
                .withSeed(seed)
                .withLimit(Duration.ofSeconds(700)));
        assertThat(watch.guards(0)).hasSize(4);
        assertThat(watch.guards(220)).hasSize(3);
        assertThat(watch.metric("worstIdleness")).isLessThan(600);
        RunEvent gone = watch.events.stream()
                .filter(event -> event.text().startsWith("gone"))
                .findFirst()
                .orElseThrow();
        String worker = gone.subject().replace("guard", "worker");
        Handover place = Handover.of(watch.events, gone, worker);
        assertThat(place.job()).startsWith("visit ");
        assertThat(place.taken())
                .get(DURATION)
                .isLessThanOrEqualTo(Handover.most(watch.events, gone, worker, "waiting for a job"));
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void guardsWhoseBatteriesRunLowAreChargedAndGoOn(long seed) {
        Watch watch = watch("recharging", seed, 900);
        assertThat(watch.metric("collisions")).isZero();
        for (int guard = 1; guard <= 4; guard++) {
            assertThat(watch.metric("leastCharge.guard-" + guard)).isBetween(0.05, 0.3);
        }
        assertThat(watch.guards(600)).hasSize(4);
        assertThat(watch.metric("worstIdleness")).isLessThan(500);
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void anIntruderIsMetWhileOthersWatchAndPatrolsGoOn(long seed) {
        Watch watch = watch("intruder", seed, 600);
        assertThat(watch.metric("collisions")).isZero();
        assertThat(watch.metric("captureTime")).isLessThan(300);
        assertThat(watch.metric("captureDistance")).isLessThan(2);
        assertThat(watch.metric("worstIdleness")).isLessThan(450);
        assertThat(watch.guards((long) watch.metric("captureTime") + 60)).hasSize(4);
        assertThat(watch.events)
                .extracting(RunEvent::text)
                .anyMatch(text -> text.matches("worker-\\d, accept-proposal: meet intruder 1 .*"))
                .anyMatch(text -> text.startsWith("patrol, inform: met at "));
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void guardsSpreadEveryFourMinutesAndWatchInBetween(long seed) {
        Watch watch = watch("distributed", seed, 720);
        assertThat(watch.metric("collisions")).isZero();
        assertThat(watch.metric("worstIdleness")).isLessThan(400);
        for (long from = 0; from < 720; from += 240) {
            assertThat(watch.spread(from, from + 120))
                    .as("seed %d, from %d s", seed, from)
                    .hasSize(4);
            assertThat(watch.guards(from + 20, from + 240))
                    .as("seed %d, from %d s", seed, from)
                    .hasSize(4);
        }
    }

    /// Every minute, which leaves less time to watch.
    @Trials({"1", "2", "3"})
    @LongTest
    void whoDoesNotAnswerIsNotWaitedForWhenTheOthersSpread(long seed) {
        Watch watch = watch(RunOptions.NONE
                .withConfiguration("faulty")
                .withJoined("distribution:found")
                .withSeed(seed)
                .withLimit(Duration.ofMinutes(10)));
        assertThat(watch.spread(0, 200)).hasSize(4);
        assertThat(watch.guards(0, 200)).hasSize(4);
        for (long from = 240; from < 600; from += 120) {
            assertThat(watch.spread(from, from + 120))
                    .as("seed %d, from %d s", seed, from)
                    .hasSizeGreaterThanOrEqualTo(2); // the one that is gone may be in the third one's way
        }
        assertThat(watch.spread(240, 600)).hasSize(3);
        assertThat(watch.guards(240, 600)).hasSize(3);
    }

    @Test
    @LongTest
    void placesCanBeFound() {
        Watch watch = watch("found", 1, 300);
        assertThat(watch.guards(0)).hasSize(4);
        assertThat(watch.events)
                .filteredOn(event -> event.text().startsWith("We watch "))
                .hasSize(1);
    }
}
