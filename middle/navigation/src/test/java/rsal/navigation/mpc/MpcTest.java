package rsal.navigation.mpc;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.ControllerContract;
import rsal.navigation.avoid.Obstacles;
import rsal.testkit.Trials;

class MpcTest extends ControllerContract {
    @Override
    protected Controller planner(Footprint footprint, double reaction, double beat) {
        return new Mpc(footprint, LIMITS, new Mpc.Settings(8, 0.05, 0.5, 4), reaction, beat);
    }

    @Trials({"1", "2", "3", "4"})
    void reportsAPathThatIsFree(long seed) {
        assertReportsFreePaths(seed, 0.05);
    }

    @Test
    void followsAPlannedWayThatLeadsOutOfView() {
        Point2d far = new Point2d(0, 30);
        var target = new Target(new Point2d(0, 1), false, List.of(new Point2d(0, 0), far));
        Twist2d command =
                planner(BOX, 0.2, 0.1).drive(new Obstacles(3), target, new Motion(Pose2d.ORIGIN, Twist2d.STOP));
        assertThat(command.omega()).isGreaterThan(0.5);
    }

    @Test
    void findsOutOfADeadEnd() {
        var walls = new ArrayList<Point2d>();
        for (double along = -1; along <= 1; along += 0.05) {
            walls.add(new Point2d(1.5, along)); // the end
            walls.add(new Point2d(along + 0.5, 1));
            walls.add(new Point2d(along + 0.5, -1));
        }
        Drive drive = new Drive(BOX, walls);
        drive.goTo(new Point2d(3, 0), 60);
        assertThat(drive.pose().position().distanceTo(new Point2d(3, 0))).isLessThan(0.4);
    }
}
