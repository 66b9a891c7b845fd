package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.Navigator;
import rsal.device.Planner;
import rsal.robot.DeviceDriver;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.LongTest;
import rsal.testkit.contract.DeviceContract;

class ExplorerTest extends DeviceContract<Explorer> {
    ExplorerTest() {
        super(Explorer.class);
    }

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new SlamDriver(), new NavigatorDriver(), new ExplorerDriver(), new ExploredDriver());
    }

    /// And its planner knows ways as far as that map.
    @Test
    void reportsTheMapAsItGrowsUntilNothingIsLeftToSee() {
        Planner planner = robot().require(Planner.class);
        Pose2d start = WORLD.pose('@', 0);
        Pose2d far = WORLD.pose('c', 0);
        var maps = new ArrayList<Stamped<OccupancyGrid>>();
        device().subscribe(maps::add);
        assertThat(planned(planner, start, far)).isInstanceOf(Planner.Result.NoPath.class);
        advance(300);

        assertThat(maps).hasSizeGreaterThan(50).allMatch(map -> map.frame().equals("map"));
        assertThat(free(maps.getLast().value()))
                .isGreaterThan(free(maps.getFirst().value()));
        OccupancyGrid map = maps.getLast().value();
        for (char place : new char[] {'@', 'a', 'b', 'c'}) {
            assertThat(map.isFree(WORLD.pose(place, 0).x(), WORLD.pose(place, 0).y()))
                    .as("%s", place)
                    .isTrue();
        }
        assertThat(device().frontier()).isEmpty();
        assertThat(robot().require(Navigator.class).goal()).isEmpty();
        assertThat(simulation().contacts()).isEmpty();
        assertThat(planned(planner, start, far))
                .isInstanceOfSatisfying(
                        Planner.Result.Found.class,
                        way -> assertThat(way.cost()).isGreaterThanOrEqualTo(start.distanceTo(far) - 0.5));
    }

    @Test
    void whoPausesTheNavigatorHasTheRobotForHimself() {
        advance(20);
        Navigator navigator = robot().require(Navigator.class);
        navigator.pause();
        advance(2);
        var stands = truth();
        advance(20);
        assertThat(truth()).isEqualTo(stands);
        navigator.resume();
        advance(20);
        assertThat(truth()).isNotEqualTo(stands);
    }

    @LongTest
    @Test
    void whoPausesItDrivesByItsNavigatorOnWhatIsMapped() {
        Navigator navigator = robot().require(Navigator.class);
        advance(60);
        device().pause();
        Pose2d start = WORLD.pose('@', 0);
        var back = navigator
                .goTo(start, Navigator.Tolerance.position(0.3))
                .result()
                .toCompletableFuture();
        advance(60);
        assertThat(back.getNow(null)).isInstanceOf(Navigator.Result.Reached.class);
        var stands = truth();
        advance(20);
        assertThat(truth()).isEqualTo(stands);
        assertThat(device().latest().orElseThrow().time()).isAfter(run.instant().minusSeconds(4));
        device().resume();
        advance(20);
        assertThat(truth()).isNotEqualTo(stands);
    }

    private Planner.Result planned(Planner planner, Pose2d from, Pose2d to) {
        var plan = planner.plan(from, to).toCompletableFuture();
        advance(1);
        return plan.join();
    }

    private static long free(OccupancyGrid map) {
        long free = 0;
        for (byte cell : map.cells()) {
            free += cell == OccupancyGrid.FREE ? 1 : 0;
        }
        return free;
    }
}
