package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Pose2d;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;

/// Two robots that must pass the same narrow door at the same time, each the other way.
class NarrowDoorTest {
    /// The door is 1 m wide.
    private static final DrawnMap ROOMS = DrawnMap.grid(0.25, """
            #########################################
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #.........a...................b.........#
            #.......................................#
            #.......................................#
            #.......................................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #...................#...................#
            #########################################""");

    @ParameterizedTest
    @CsvSource({"vfh, 1", "vfh, 2", "vfh, 3", "nd, 1", "nd, 2", "snd, 1", "snd, 2", "mpc, 1"})
    void bothGetThrough(String planner, long seed) {
        NavigationRun run = run(planner, seed);
        assertThat(change(run)).hasSize(2).allMatch(Result.Reached.class::isInstance);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// They may get stuck there.
    @LongTest
    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void withDwaTheyTouchNothingAndSayWhatCameOfIt(long seed) {
        NavigationRun run = run("dwa", seed);
        assertThat(change(run))
                .hasSize(2)
                .allSatisfy(result -> assertThat(result).isInstanceOfAny(Result.Reached.class, Result.Stuck.class));
        assertThat(run.simulation.contacts()).isEmpty();
    }

    private static NavigationRun run(String planner, long seed) {
        Pose2d left = ROOMS.pose('a', 0);
        Pose2d right = ROOMS.pose('b', Math.PI);
        var model = NavigationRun.pioneer("urg04lx");
        return new NavigationRun(
                        ROOMS.grid(),
                        seed,
                        Runnable::run,
                        List.of(NavigationRun.robot("r0", model, left), NavigationRun.robot("r1", model, right)))
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of("controller", planner));
    }

    /// Sends each to where the other is; within three minutes.
    private static List<Result> change(NavigationRun run) {
        run.advance(1);
        var results = new ArrayList<Result>();
        run.navigator("r0")
                .goTo(ROOMS.pose('b', Math.PI), Tolerance.position(0.4))
                .result()
                .thenAccept(results::add);
        run.navigator("r1")
                .goTo(ROOMS.pose('a', 0), Tolerance.position(0.4))
                .result()
                .thenAccept(results::add);
        for (int second = 0; second < 180 && results.size() < 2; second++) {
            run.advance(1);
        }
        return results;
    }
}
