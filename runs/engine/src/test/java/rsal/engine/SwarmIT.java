package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.Point2d;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(300)
class SwarmIT {
    private static final Scenario SWARM = Scenario.load("swarm");

    private static RunResult run(String configuration, long seed, double seconds, int helpers) {
        var options = RunOptions.NONE
                .withConfiguration(configuration)
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withLimit(Duration.ofMillis(Math.round(seconds * 1000)));
        try (var run = LiveRun.of(SWARM.plan(options)).helpers(helpers).start()) {
            return run.result()
                    .toCompletableFuture()
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
        }
    }

    private static double metric(RunResult result, String name) {
        return result.metrics().get(name).getAsDouble();
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void tenSpreadOutAlongTheWallsAndKnowWhereTheyAre(long seed) {
        RunResult result = run("ten", seed, 40, 1);
        assertThat(metric(result, "distance")).isGreaterThan(10 * 10);
        assertThat(metric(result, "localizationError")).isLessThan(0.35);
        assertThat(metric(result, "collisions")).isZero();
        assertThat(metric(result, "receivedMessages")).isEqualTo(9 * metric(result, "messages"));
    }

    @LongTest
    @Trials({"1", "2", "3"})
    void tenAreFartherFromEachOtherThanTheyWereAtFirst(long seed) {
        assertThat(apart(seed, 40)).isGreaterThan(apart(seed, 0.1));
    }

    /// Mean distance of ten to the nearest other [m].
    private static double apart(long seed, double seconds) {
        var options = RunOptions.NONE
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withConfiguration("ten")
                .withLimit(Duration.ofMillis(Math.round(seconds * 1000)));
        try (var run = LiveRun.start(SWARM.plan(options))) {
            Runs.result(run);
            List<Point2d> places = run.snapshot().robots().stream()
                    .map(robot -> robot.truth().orElseThrow().position())
                    .toList();
            assertThat(places).hasSize(10);
            return places.stream()
                    .mapToDouble(place -> places.stream()
                            .filter(other -> !other.equals(place))
                            .mapToDouble(place::distanceTo)
                            .min()
                            .orElseThrow())
                    .average()
                    .orElseThrow();
        }
    }

    @Test
    @LongTest
    void eightMapTheOfficeFloorTogether() {
        var options = RunOptions.NONE
                .withConfiguration("coverage")
                .withArguments(Map.of("robots", "8"))
                .withSeed(1)
                .withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(SWARM.plan(options))) {
            RunResult result = run.result()
                    .toCompletableFuture()
                    .orTimeout(250, TimeUnit.SECONDS)
                    .join();
            assertThat(result.outcome()).isEqualTo("success");
            assertThat(metric(result, "time99")).isLessThan(600);
        }
    }

    @Test
    @LongTest
    void aHundredDoTheSameOnOneCoreAndMore() {
        RunResult alone = run("hundred", 1, 3, 1);
        assertThat(run("hundred", 1, 3, 3).eventHash()).isEqualTo(alone.eventHash());
        assertThat(metric(alone, "collisions")).isZero();
    }

    @Test
    @LongTest
    void aThousandBegin() {
        RunResult result = run("thousand", 1, 1, 1);
        assertThat(metric(result, "messages")).isEqualTo(3000); // a greeting each, and where they are
        assertThat(metric(result, "receivedMessages")).isEqualTo(999 * 3000);
        assertThat(metric(result, "distance")).isGreaterThan(50);
        assertThat(metric(result, "wallCollisions")).isZero();
    }

    @Test
    @LongTest
    void allGoToPlacesOfTheirOwnWhenDistributionJoins() {
        var options = RunOptions.NONE
                .withJoined("distribution:found")
                .withSeed(1)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withLimit(Duration.ofSeconds(10));
        try (var run = LiveRun.start(SWARM.plan(options))) {
            RunResult result = run.result()
                    .toCompletableFuture()
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
            var goals = run.snapshot().robots().stream()
                    .flatMap(robot -> robot.goal().stream())
                    .toList();
            assertThat(goals).as("they are on their long way").hasSize(10).doesNotHaveDuplicates();
            assertThat(metric(result, "collisions")).isZero();
        }
    }

    /// @param formation what its leader did, by time
    private record Marched(RunResult result, NavigableMap<Double, String> formation, List<Double> faults) {}

    private static Marched march(String configuration, long seed, String shape) {
        var options = RunOptions.NONE
                .withConfiguration(configuration)
                .withSeed(seed)
                .withSpeed(Double.POSITIVE_INFINITY)
                .withArguments(Map.of("shape", shape));
        try (var run = LiveRun.start(SWARM.plan(options))) {
            RunResult result = run.result()
                    .toCompletableFuture()
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
            var formation = new TreeMap<Double, String>();
            var faults = new ArrayList<Double>();
            for (RunEvent event : run.events(0)) {
                double time = event.time().toMillis() * 1e-3;
                if (event.subject().equals("formation")) {
                    formation.put(time, event.text());
                }
                if (event.kind().equals("fault") && event.text().startsWith("gone")) {
                    faults.add(time);
                }
            }
            return new Marched(result, formation, faults);
        }
    }

    @Trials({"wedge, 2", "line, 1", "circle, 3", "grid, 4"})
    void aFormationIsHeldAcrossTheCaveAndGoesInAColumnWhereThatIsNarrow(String shape, long seed) {
        Marched marched = march("formation", seed, shape);
        assertThat(marched.result.outcome()).isEqualTo("success");
        assertThat(metric(marched.result, "arrived")).isEqualTo(6);
        assertThat(metric(marched.result, "collisions")).isZero();
        assertThat(metric(marched.result, "formationError")).isLessThan(0.7);
        assertThat(metric(marched.result, "formationTime")).isLessThan(200);
        assertThat(marched.formation.values())
                .contains("leading a column of 6", "leading a %s of 6".formatted(shape), "has arrived");
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void theOthersCloseRanksWithinFourSecondsWhenSomeStopAndFallSilent(long seed) {
        Marched marched = march("faulty", seed, "wedge");
        assertThat(marched.result.outcome()).isEqualTo("success");
        assertThat(metric(marched.result, "arrived")).isGreaterThanOrEqualTo(5);
        assertThat(marched.faults).hasSize(3);
        double first = marched.faults.getFirst();
        double last = marched.faults.getLast();
        assertThat(marched.formation.subMap(first, first + 4).values())
                .anyMatch(words -> words.matches("forming a .* of 7"));
        assertThat(marched.formation.subMap(last, last + 4).values())
                .anyMatch(words -> words.matches("forming a .* of 5"));
    }
}
