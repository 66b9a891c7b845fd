package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Stamped;
import rsal.device.Navigator;
import rsal.robot.DeviceDriver;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
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
        return List.of(new SlamDriver(), new NavigatorDriver(), new ExplorerDriver());
    }

    @Test
    void tellsTheMapAsItGrowsUntilNothingIsLeftToSee() {
        var maps = new ArrayList<Stamped<OccupancyGrid>>();
        device().subscribe(maps::add);
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

    private static long free(OccupancyGrid map) {
        long free = 0;
        for (byte cell : map.cells()) {
            free += cell == OccupancyGrid.FREE ? 1 : 0;
        }
        return free;
    }
}
