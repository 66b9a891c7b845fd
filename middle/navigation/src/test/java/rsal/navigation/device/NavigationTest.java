package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.concurrent.Executors;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.device.SimulationControl.Placement;
import rsal.map.Maps;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Wavefront;
import rsal.robot.RobotSpec;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.testkit.LongTest;
import rsal.testkit.Trials;
import rsal.testkit.contract.RobotBench;

/// Localizers and navigators at work on the office floor, several robots at once.
class NavigationTest {
    private static final OccupancyGrid OFFICE =
            new Maps(FileSource.resources(NavigationTest.class, "/")).read("office", Location.of("test"));
    private static final CostMap ROOM_TO_DRIVE =
            CostMap.of(OFFICE, DistanceField.toNotFree(OFFICE), new CostMap.Clearance(0.35, 0.7, 3));
    private static final List<String> IDS = List.of("r0", "r1", "r2");

    @Trials({"1", "2", "3"})
    void threeRobotsReachWhatTheyAreSentToAndKnowWhereTheyAre(long seed) {
        var random = new SplittableRandom(seed);
        NavigationRun run = officeRun(seed, Runnable::run, random);
        var results = new ArrayList<Result>();
        var errors = new ArrayList<Double>();
        for (int beat = 0; beat < 3000; beat++) {
            sendTheIdle(run, random, results);
            run.advance(0.1);
            IDS.forEach(id -> errors.add(run.error(id)));
        }
        errors.sort(null);
        assertThat(errors.get(errors.size() * 95 / 100))
                .as("p95, seed %d", seed)
                .isLessThan(0.1);
        assertThat(errors.getLast()).as("worst, seed %d", seed).isLessThan(0.3);
        assertThat(results).as("seed %d", seed).hasSizeGreaterThan(8);
        assertThat(results).as("seed %d", seed).allMatch(Result.Reached.class::isInstance);
        assertThat(run.simulation.contacts()).as("seed %d", seed).isEmpty();
    }

    @Test
    void aRunIsTheSameOnOneThreadAndOnTwo() throws Exception {
        List<Pose2d> alone = placesAfterAMinute(Runnable::run);
        try (var workers = Executors.newFixedThreadPool(2)) {
            assertThat(placesAfterAMinute(workers)).isEqualTo(alone);
        }
        assertThat(placesAfterAMinute(Runnable::run)).isEqualTo(alone);
    }

    @LongTest
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void withoutAStartItFindsOutWhereItIs(long seed) {
        var random = new SplittableRandom(seed);
        NavigationRun run = new NavigationRun(OFFICE, seed, Runnable::run, List.of(pioneer("r0", random)))
                .withoutStarts()
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of());
        for (int goal = 0; goal < 3; goal++) {
            run.navigator("r0").goTo(place(random), Tolerance.position(0.4));
            run.advance(40);
        }
        assertThat(run.error("r0")).as("seed %d", seed).isLessThan(0.2);
    }

    @Test
    void carriedAwayItFindsItselfAgain() {
        var random = new SplittableRandom(5);
        NavigationRun run = officeRun(5, Runnable::run, random);
        run.advance(2);
        assertThat(run.simulation.place("r0", place(random))).isInstanceOf(Placement.Placed.class);
        assertThat(run.error("r0")).isGreaterThan(2);
        turnAround(run, 30); // on one spot, a place that looks alike may fit as well
        run.navigator("r0").goTo(place(random), Tolerance.position(0.4));
        run.advance(150);
        assertThat(run.error("r0")).isLessThan(0.3);
    }

    @Test
    void reportedWhereItIsItStartsAgainFromThere() {
        var random = new SplittableRandom(6);
        NavigationRun run = officeRun(6, Runnable::run, random);
        run.advance(2);
        Pose2d there = place(random);
        assertThat(run.simulation.place("r0", there)).isInstanceOf(Placement.Placed.class);
        Pose2d aboutThere = there.compose(new Pose2d(0.2, -0.1, 0.1));
        var reported = run.localizer("r0")
                .relocalize(PoseEstimate.of(aboutThere, Covariance2d.ofDeviations(0.3, 0.3, 0.2)))
                .toCompletableFuture();
        run.advance(0.5);
        assertThat(reported).isCompleted();
        assertThat(run.error("r0")).isLessThan(0.2);
    }

    @Test
    void sonarsWillDoToFollowWhereOneIs() {
        var random = new SplittableRandom(7);
        var specs = List.of(NavigationRun.robot("r0", NavigationRun.pioneer("none"), place(random)));
        NavigationRun run = new NavigationRun(OFFICE, 7, Runnable::run, specs).with(new AmclDriver(), Map.of());
        turnAround(run, 20);
        assertThat(run.error("r0")).isLessThan(0.3);
    }

    @LongTest
    @Test
    void itGoesOnWhenMotorsAreOnAgainHoweverLongTheyWereOff() {
        NavigationRun run = officeRun(8, Runnable::run, new SplittableRandom(8));
        run.advance(1);
        var ended = new ArrayList<Result>();
        run.navigator("r0")
                .goTo(farFrom(run.truth("r0")), Tolerance.position(0.4))
                .result()
                .thenAccept(ended::add);
        run.advance(3);
        run.base("r0").enable(false);
        run.advance(1);
        Pose2d stopped = run.truth("r0");
        run.advance(120);
        assertThat(run.truth("r0")).isEqualTo(stopped);
        assertThat(ended).isEmpty();
        run.base("r0").enable(true);
        run.advance(200);
        assertThat(ended).singleElement().isInstanceOf(Result.Reached.class);
    }

    @Test
    void aPauseLastsAsLongAsItLikes() {
        NavigationRun run = officeRun(8, Runnable::run, new SplittableRandom(8));
        run.advance(1);
        var ended = new ArrayList<Result>();
        run.navigator("r0")
                .goTo(farFrom(run.truth("r0")), Tolerance.position(0.4))
                .result()
                .thenAccept(ended::add);
        run.advance(3);
        run.navigator("r0").pause();
        run.advance(1);
        Pose2d stopped = run.truth("r0");
        run.advance(120);
        assertThat(run.truth("r0")).isEqualTo(stopped);
        assertThat(ended).isEmpty();
        run.navigator("r0")
                .goTo(farFrom(stopped), Tolerance.position(0.4))
                .result()
                .thenAccept(ended::add);
        run.advance(10);
        assertThat(run.truth("r0")).as("a new goal does not end the pause").isEqualTo(stopped);
        assertThat(ended).singleElement().isInstanceOf(Result.Cancelled.class);
        run.navigator("r0").resume();
        run.advance(200);
        assertThat(ended).hasSize(2).last().isInstanceOf(Result.Reached.class);
    }

    @Test
    void aTurnAtTheGoalMayTakeLongerThanItsPatience() {
        var specs = List.of(NavigationRun.robot("r0", NavigationRun.pioneer("urg04lx"), RobotBench.START));
        NavigationRun run = new NavigationRun(RobotBench.WORLD.grid(), 9, Runnable::run, specs)
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of("timeout", 6.0, "maxTurnRate", 10.0));
        run.advance(1);
        var ended = new ArrayList<Result>();
        run.navigator("r0")
                .goTo(RobotBench.START.compose(new Pose2d(1.5, 0, 3)))
                .result()
                .thenAccept(ended::add);
        run.advance(60);
        assertThat(ended).hasSize(1).first().isInstanceOf(Result.Reached.class);
    }

    private static List<Pose2d> placesAfterAMinute(Executor workers) {
        var random = new SplittableRandom(4);
        NavigationRun run = officeRun(4, workers, random);
        var results = new ArrayList<Result>();
        for (int beat = 0; beat < 600; beat++) {
            sendTheIdle(run, random, results);
            run.advance(0.1);
        }
        return IDS.stream().map(run::truth).toList();
    }

    private static NavigationRun officeRun(long seed, Executor workers, SplittableRandom random) {
        var specs = IDS.stream().map(id -> pioneer(id, random)).toList();
        return new NavigationRun(OFFICE, seed, workers, specs)
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of());
    }

    private static RobotSpec pioneer(String id, SplittableRandom random) {
        return NavigationRun.robot(id, NavigationRun.pioneer("urg04lx"), place(random));
    }

    private static void sendTheIdle(NavigationRun run, SplittableRandom random, List<Result> results) {
        for (String id : IDS) {
            if (run.navigator(id).goal().isEmpty()) {
                run.navigator(id)
                        .goTo(place(random), Tolerance.DEFAULT)
                        .result()
                        .thenAccept(results::add);
            }
        }
    }

    private static void turnAround(NavigationRun run, int seconds) {
        for (int beat = 0; beat < 10 * seconds; beat++) {
            run.robot("r0").require(DriveBase.class).command(Twist2d.drive(0, 0.5));
            run.advance(0.1);
        }
    }

    private static Pose2d farFrom(Pose2d place) {
        return new Pose2d(place.x() > 0 ? -20 : 20, -1.2, 0);
    }

    /// Somewhere in the office that can be reached from the corridor.
    private static Pose2d place(SplittableRandom random) {
        while (true) {
            var place = new Point2d(random.nextDouble(-31, 31), random.nextDouble(-7.5, 7.5));
            if (ROOM_TO_DRIVE.isPassable(place)
                    && new Wavefront(ROOM_TO_DRIVE).plan(place, new Point2d(0, -1.2), 0) instanceof Plan.Found) {
                return new Pose2d(place.x(), place.y(), random.nextDouble(-3, 3));
            }
        }
    }
}
