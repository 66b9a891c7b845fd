package rsal.engine;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.TimeUnit;
import org.junit.jupiter.api.Timeout;
import rsal.data.Point2d;
import rsal.engine.report.RunEvent;
import rsal.engine.report.RunResult;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;

@Timeout(300)
class DistributionIT {
    private static final Scenario DISTRIBUTION = Scenario.load("distribution");
    private static final int ROBOTS = 6;
    private static final double CORRIDOR_BOTTOM = -2.4; // m, of the office floor, all along it
    private static final double CORRIDOR_TOP = 0.4;

    /// @param ends where the robots were at the end, by id
    private record Dispersal(RunResult result, List<RunEvent> events, Map<String, Point2d> ends) {
        double metric(String name) {
            return result.metrics().get(name).getAsDouble();
        }

        List<String> gone() {
            return events.stream()
                    .filter(event ->
                            event.kind().equals("fault") && event.text().startsWith("gone"))
                    .map(RunEvent::subject)
                    .toList();
        }
    }

    private static Dispersal disperse(String configuration, long seed) {
        var options =
                RunOptions.NONE.withConfiguration(configuration).withSeed(seed).withSpeed(Double.POSITIVE_INFINITY);
        try (var run = LiveRun.start(DISTRIBUTION.plan(options))) {
            var result = run.result()
                    .toCompletableFuture()
                    .orTimeout(120, TimeUnit.SECONDS)
                    .join();
            var ends = new HashMap<String, Point2d>();
            run.snapshot()
                    .robots()
                    .forEach(robot ->
                            ends.put(robot.id(), robot.truth().orElseThrow().position()));
            return new Dispersal(result, run.events(0), ends);
        }
    }

    @Trials({"virtual, 1", "found, 1", "virtual, 2", "virtual, 3", "found, 2", "found, 3"})
    void allRobotsArriveWithoutACollision(String configuration, long seed) {
        Dispersal dispersal = disperse(configuration, seed);
        assertThat(dispersal.result.outcome()).isEqualTo("success");
        assertThat(dispersal.metric("arrived")).isEqualTo(ROBOTS);
        assertThat(dispersal.metric("collisions")).isZero();
        assertFarFromEachOther(dispersal, 4);
    }

    @Trials({"found, 1", "found, 2", "found, 3"})
    @LongTest
    void eachRobotStandsInARoom(String configuration, long seed) {
        assertThat(disperse(configuration, seed).ends.values())
                .noneMatch(place -> place.y() > CORRIDOR_BOTTOM && place.y() < CORRIDOR_TOP);
    }

    @Trials({"1", "2", "3"})
    @LongTest
    void theOthersArriveWhenOneStopsOnItsWayAndMessagesAreLost(long seed) {
        Dispersal dispersal = disperse("faulty", seed);
        assertThat(dispersal.result.outcome()).isEqualTo("success");
        assertThat(dispersal.gone()).hasSize(1);
        assertThat(dispersal.metric("arrived")).isGreaterThanOrEqualTo(ROBOTS - 1);
        assertFarFromEachOther(dispersal, 4);
    }

    /// Those that are not gone.
    private static void assertFarFromEachOther(Dispersal dispersal, double least) {
        var present = new ArrayList<>(dispersal.ends.keySet());
        present.removeAll(dispersal.gone());
        for (String one : present) {
            for (String other : present) {
                if (!one.equals(other)) {
                    assertThat(dispersal.ends.get(one).distanceTo(dispersal.ends.get(other)))
                            .as("%s to %s, seed %d", one, other, dispersal.result.seed())
                            .isGreaterThan(least);
                }
            }
        }
    }
}
