package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.traffic.LossyLinks;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;

/// Two robots that talk to each other, and have to change places where they cannot pass each other.
class TrafficTest {
    /// 0.75 m wide, in a wall of 0.25 m; the rooms are 2.5 m and 2.75 m long.
    private static final DrawnMap DOOR = DrawnMap.grid(0.25, """
            ########################
            #..........#...........#
            #..........#...........#
            #..........#...........#
            #......................#
            #..a..............b....#
            #......................#
            #..........#...........#
            #..........#...........#
            #..........#...........#
            ########################""");

    /// 1.2 m wide and 6 m long.
    private static final DrawnMap CORRIDOR = DrawnMap.grid(0.2, """
            ##########################################################
            #.............##############################.............#
            #.............##############################.............#
            #.............##############################.............#
            #.............##############################.............#
            #........................................................#
            #........................................................#
            #....a..............................................b....#
            #........................................................#
            #........................................................#
            #........................................................#
            #.............##############################.............#
            #.............##############################.............#
            #.............##############################.............#
            #.............##############################.............#
            ##########################################################""");

    @ParameterizedTest
    @ValueSource(strings = {"vfh", "dwa"})
    void changePlacesThroughADoor(String controller) {
        assertThatBothArrive(DOOR, controller, 1, 0);
    }

    @LongTest
    @ParameterizedTest
    @CsvSource({
        "vfh, 1", "vfh, 2", "vfh, 3", "nd, 1", "nd, 2", "nd, 3", "snd, 1", "snd, 2", "snd, 3", "dwa, 2", "dwa, 3",
        "mpc, 1", "mpc, 2", "mpc, 3"
    })
    void changePlacesThroughADoorWithAnyController(String controller, long seed) {
        assertThatBothArrive(DOOR, controller, seed, 0);
    }

    @LongTest
    @ParameterizedTest
    @CsvSource({"vfh, 1", "vfh, 2", "vfh, 3", "nd, 1", "nd, 2", "snd, 1", "snd, 2", "mpc, 1", "mpc, 2"})
    void changePlacesThroughACorridor(String controller, long seed) {
        assertThatBothArrive(CORRIDOR, controller, seed, 0);
    }

    /// The one that waited may get stuck in front of the one that has arrived.
    @LongTest
    @ParameterizedTest
    @ValueSource(longs = {1, 2})
    void withDwaOneAtLeastGetsThroughACorridor(long seed) {
        NavigationRun run = run(CORRIDOR, "dwa", seed, 0);
        List<Result> results = change(run, CORRIDOR);
        assertThat(results).anyMatch(Result.Reached.class::isInstance);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    @LongTest
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void changePlacesThoughAThirdOfTheMessagesIsLost(long seed) {
        assertThatBothArrive(DOOR, "vfh", seed, 0.33);
    }

    /// The one that stands in the door says nothing any more, and the other ends with a reason.
    @Test
    void aRobotThatStandsInTheDoorClosesIt() {
        NavigationRun run = run(DOOR, "vfh", 1, 0);
        run.advance(1);
        var results = new ArrayList<Result>();
        run.navigator("r0").goTo(new Pose2d(2.875, 1.375, 0), Tolerance.position(0.2));
        run.advance(15);
        run.navigator("r1")
                .goTo(DOOR.pose('a', Math.PI), Tolerance.position(0.3))
                .result()
                .thenAccept(results::add);
        run.advance(30);
        assertThat(results).isEmpty();
        run.advance(75);
        assertThat(results).hasSize(1);
        assertThat(results.getFirst().toString()).contains("blocks a narrow passage");
    }

    private static void assertThatBothArrive(DrawnMap map, String controller, long seed, double loss) {
        NavigationRun run = run(map, controller, seed, loss);
        assertThat(change(run, map)).hasSize(2).allMatch(Result.Reached.class::isInstance);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// Sends each to where the other is; within 150 s.
    private static List<Result> change(NavigationRun run, DrawnMap map) {
        run.advance(1);
        var results = new ArrayList<Result>();
        run.navigator("r0")
                .goTo(map.pose('b', Math.PI), Tolerance.position(0.3))
                .result()
                .thenAccept(results::add);
        run.navigator("r1")
                .goTo(map.pose('a', 0), Tolerance.position(0.3))
                .result()
                .thenAccept(results::add);
        for (int second = 0; second < 150 && results.size() < 2; second++) {
            run.advance(1);
        }
        return results;
    }

    private static NavigationRun run(DrawnMap map, String controller, long seed, double loss) {
        var model = NavigationRun.pioneer("urg04lx");
        var links = new LossyLinks(seed, loss);
        return new NavigationRun(
                        map.grid(),
                        seed,
                        Runnable::run,
                        List.of(
                                NavigationRun.robot("r0", model, map.pose('a', 0)),
                                NavigationRun.robot("r1", model, map.pose('b', Math.PI))))
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of("controller", controller), links::link);
    }
}
