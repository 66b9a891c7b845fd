package rsal.navigation.device;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.robot.DeviceDriver;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.NavigatorContract;

class PathNavigatorTest extends NavigatorContract {
    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new AmclDriver(), new NavigatorDriver());
    }

    @Test
    void reportsThePathOfItsLocalPlanner() {
        device().goTo(WORLD.pose('a', 0));
        advance(3);
        Path2d way = device().localPath();
        assertThat(way.length()).isBetween(0.2, 1.5);
        List<Point2d> planned = device().path().points();
        double before = way.points().getFirst().distanceTo(planned.get(1));
        assertThat(way.points().get(1).distanceTo(planned.get(1))).isLessThan(before);
    }
}
