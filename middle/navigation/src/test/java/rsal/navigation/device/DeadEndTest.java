package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.OccupancyGrid;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.testkit.DrawnMap;
import rsal.testkit.LongTest;

/// A robot that is sent to what lies behind the end of a nook, from before the nook or from in it.
class DeadEndTest {
    private static final DrawnMap HALL = DrawnMap.grid(0.2, """
            ###########################################
            #...........#.............................#
            #...........#.............................#
            #...........#.............................#
            #...........#.............................#
            #.........................................#
            #.........................................#
            #.........................................#
            #.........................................#
            #.............##############..............#
            #..........................#..............#
            #..........................#..............#
            #..........................#..............#
            #..........................#..............#
            #......a..............b....#......g.......#
            #..........................#..............#
            #..........................#..............#
            #..........................#..............#
            #..........................#..............#
            #..........................#..............#
            ####..........##############..............#
            #.........................................#
            #.........................................#
            #.........................................#
            #.........................................#
            #................................##.......#
            #................................##.......#
            #................................##.......#
            #................................##.......#
            ###########################################""");

    @ParameterizedTest
    @ValueSource(strings = {"vfh", "nd", "snd", "dwa", "mpc"})
    void turnsAroundInADeadEndThatItKnows(String planner) {
        NavigationRun run = run(HALL.grid(), planner, 'b');
        assertThat(goBehindTheEnd(run)).singleElement().isInstanceOf(Result.Reached.class);
        assertThat(run.truth("r").distanceTo(HALL.pose('g', 0))).isLessThan(0.6);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    @LongTest
    @ParameterizedTest
    @CsvSource({"vfh, a", "vfh, b", "nd, a", "nd, b", "snd, a", "snd, b", "dwa, a", "mpc, a", "mpc, b"})
    void findsOutOfADeadEndThatIsNotOnItsMap(String planner, char from) {
        NavigationRun run = run(withoutNook(), planner, from);
        assertThat(goBehindTheEnd(run)).singleElement().isInstanceOf(Result.Reached.class);
        assertThat(run.truth("r").distanceTo(HALL.pose('g', 0))).isLessThan(0.6);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    /// It drives so near to an end that it has no room to turn, and moves to and fro there until it may be lost in what
    /// its map doesn't show.
    @Test
    void withDwaItMayGetStuckBeforeTheEndAndSaysSo() {
        NavigationRun run = run(withoutNook(), "dwa", 'b');
        assertThat(goBehindTheEnd(run)).singleElement().isInstanceOfAny(Result.Reached.class, Result.Stuck.class);
        assertThat(run.simulation.contacts()).isEmpty();
    }

    private static NavigationRun run(OccupancyGrid believed, String planner, char from) {
        var spec = NavigationRun.robot("r", NavigationRun.pioneer("urg04lx"), HALL.pose(from, 0));
        return new NavigationRun(HALL.grid(), 1, Runnable::run, List.of(spec))
                .on(believed)
                .with(new AmclDriver(), Map.of())
                .with(new NavigatorDriver(), Map.of("controller", planner));
    }

    /// Within five minutes.
    private static List<Result> goBehindTheEnd(NavigationRun run) {
        var results = new ArrayList<Result>();
        run.navigator("r")
                .goTo(HALL.pose('g', 0), Tolerance.position(0.4))
                .result()
                .thenAccept(results::add);
        for (int second = 0; second < 300 && results.isEmpty(); second++) {
            run.advance(1);
        }
        return results;
    }

    private static OccupancyGrid withoutNook() {
        OccupancyGrid real = HALL.grid();
        byte[] cells = real.cells().clone();
        for (int row = 9; row <= 20; row++) {
            Arrays.fill(cells, row * real.width() + 14, row * real.width() + 28, OccupancyGrid.FREE);
        }
        return new OccupancyGrid(real.width(), real.height(), real.resolution(), real.originX(), real.originY(), cells);
    }
}
