package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.traffic.LossyLinks;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.robot.TeamLink;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;
import rsal.time.Phase;

/// Robots of a team, and others that say nothing and avoid nobody.
class StrangersTest {
    private static final double APART = 0.5; // m between the middles

    /// Two doors of 1 m.
    private static final DrawnMap TWO_DOORS = DrawnMap.grid(0.25, """
            ################################
            #...............#..............#
            #...............#..............#
            #...............#..............#
            #..............................#
            #...a......................b...#
            #..............................#
            #..............................#
            #...............#..............#
            #...............#..............#
            #...............#..............#
            #...............#..............#
            #...............#..............#
            #...............#..............#
            #...............#..............#
            #..............................#
            #..............................#
            #..............................#
            #..............................#
            #...............#..............#
            #...............#..............#
            #...............#..............#
            ################################""");

    /// 10 m by 9 m.
    private static final DrawnMap HALL = DrawnMap.grid(0.5, """
            ######################
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #.a................b.#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            #....................#
            ######################""");

    /// It broke down in one door, so the others use the other one.
    @ParameterizedTest
    @ValueSource(strings = {"vfh", "dwa"})
    void othersPassByAnotherDoorWhenOneBreaksDownInTheFirst(String controller) {
        NavigationRun run = team(TWO_DOORS, controller, 1, new Pose2d(4.1, 4.3, 0.4), true);
        assertThat(changePlaces(run, TWO_DOORS, 180)).hasSize(2).allMatch(Result.Reached.class::isInstance);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// One drives about in front of the doors and through them, by itself and without a word.
    @LongTest
    @ParameterizedTest
    @CsvSource({"vfh, 1", "vfh, 2", "vfh, 3"})
    void othersArriveThoughOneWandersAboutInTheDoors(String controller, long seed) {
        NavigationRun run = team(TWO_DOORS, controller, seed, new Pose2d(3, 4.3, 0), true);
        var random = new SplittableRandom(seed);
        run.scheduler.every(
                Duration.ofSeconds(3),
                Phase.DEVICES,
                () -> run.base("stranger")
                        .command(Twist2d.drive(0.3 * random.nextDouble(-0.5, 1), random.nextDouble(-1, 1))));
        assertThat(changePlaces(run, TWO_DOORS, 240)).hasSize(2).allMatch(Result.Reached.class::isInstance);
    }

    /// Somebody walks across at 1.4 m/s without looking, and would be where the robot is then.
    @ParameterizedTest
    @CsvSource({"vfh, 1.2", "dwa, 1.6"})
    void keepsClearOfWhoWalksAcross(String controller, double lead) {
        assertThat(nearest(controller, 1, lead, true, true)).isGreaterThan(APART);
    }

    /// Somebody comes straight on.
    @ParameterizedTest
    @CsvSource({"vfh, 1.2", "dwa, 0.8"})
    void getsOutOfTheWayOfWhoComesStraightOn(String controller, double lead) {
        assertThat(nearest(controller, 1, lead, false, true)).isGreaterThan(APART);
    }

    /// So the tests above can fail.
    @Test
    void withoutPredictionItIsRunOver() {
        assertThat(nearest("vfh", 1, 1.2, true, false)).isZero();
    }

    @LongTest
    @ParameterizedTest
    @ValueSource(strings = {"vfh", "dwa", "nd", "snd"})
    void keepsClearOfWalkersWithAnyController(String controller) {
        var near = new ArrayList<String>();
        for (long seed = 1; seed <= 3; seed++) {
            for (double lead = 0.4; lead <= 2; lead += 0.4) {
                for (boolean across : new boolean[] {true, false}) {
                    double nearest = nearest(controller, seed, lead, across, true);
                    if (nearest <= APART) {
                        near.add("seed %d, %s, %.1f m: %.2f m"
                                .formatted(seed, across ? "across" : "straight on", lead, nearest));
                    }
                }
            }
        }
        assertThat(near).isEmpty();
    }

    /// Least distance between the middles of a robot and a walker [m], while the robot drives to its goal; 0 if they
    /// collided.
    ///
    /// @param lead how far before the walker's line the robot is when that one starts [m]; of who
    /// comes straight on, where beside the robot's line it walks
    private static double nearest(String controller, long seed, double lead, boolean across, boolean predicts) {
        Pose2d start = across ? new Pose2d(6, 9, -Math.PI / 2) : new Pose2d(9, 5 + lead / 4 - 0.3, Math.PI);
        NavigationRun run = new NavigationRun(
                        HALL.grid(),
                        seed,
                        Runnable::run,
                        List.of(
                                NavigationRun.robot("r0", NavigationRun.pioneer("urg04lx"), HALL.pose('a', 0)),
                                NavigationRun.robot("stranger", walker(), start)))
                .withOnly(List.of("r0"), new AmclDriver(), Map.of(), _ -> TeamLink.ALONE)
                .withOnly(
                        List.of("r0"),
                        new NavigatorDriver(),
                        Map.of("controller", controller, "predictMovers", predicts),
                        _ -> TeamLink.ALONE);
        run.advance(1);
        var results = new ArrayList<Result>();
        run.navigator("r0")
                .goTo(HALL.pose('b', 0), Tolerance.position(0.4))
                .result()
                .thenAccept(results::add);
        boolean[] goes = {false};
        run.scheduler.every(Duration.ofMillis(100), Phase.DEVICES, () -> {
            goes[0] |= run.truth("r0").x() > (across ? 6 - lead : 2.5);
            boolean ends = across
                    ? run.truth("stranger").y() < 2
                    : run.truth("stranger").x() < 2;
            run.base("stranger").command(Twist2d.drive(goes[0] && !ends ? 1.4 : 0, 0));
        });
        double nearest = 9;
        for (int i = 0; i < 450 && results.isEmpty(); i++) {
            run.advance(0.1);
            nearest = Math.min(nearest, run.truth("r0").distanceTo(run.truth("stranger")));
        }
        assertThat(results.isEmpty() || results.getFirst() instanceof Result.Reached)
                .isTrue();
        return run.simulation.contacts().isEmpty() ? nearest : 0;
    }

    private static RobotModel walker() {
        return NavigationRun.model("jackal");
    }

    private static NavigationRun team(DrawnMap map, String controller, long seed, Pose2d stranger, boolean predicts) {
        RobotModel model = NavigationRun.pioneer("urg04lx");
        var links = new LossyLinks(seed, 0);
        var specs = new ArrayList<RobotSpec>();
        specs.add(NavigationRun.robot("r0", model, map.pose('a', 0)));
        specs.add(NavigationRun.robot("r1", model, map.pose('b', Math.PI)));
        specs.add(NavigationRun.robot("stranger", model, stranger));
        NavigationRun run = new NavigationRun(map.grid(), seed, Runnable::run, specs);
        run.with(new AmclDriver(), Map.of());
        return run.withOnly(
                List.of("r0", "r1"),
                new NavigatorDriver(),
                Map.of("controller", controller, "predictMovers", predicts),
                links::link);
    }

    /// Sends each to where the other is, again and again if it gives up; those that arrived.
    private static List<Result> changePlaces(NavigationRun run, DrawnMap map, int seconds) {
        run.advance(1);
        var results = new ArrayList<Result>();
        send(run, "r0", map.pose('b', Math.PI), results);
        send(run, "r1", map.pose('a', 0), results);
        for (int second = 0; second < seconds && results.size() < 2; second++) {
            run.advance(1);
        }
        return results;
    }

    private static void send(NavigationRun run, String robot, Pose2d goal, List<Result> results) {
        run.navigator(robot).goTo(goal, Tolerance.position(0.4)).result().thenAccept(result -> {
            if (result instanceof Result.Reached) {
                results.add(result);
            } else {
                run.scheduler.after(Duration.ofSeconds(2), Phase.THINK, () -> send(run, robot, goal, results));
            }
        });
    }
}
