package rsal.navigation.mpc;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import org.junit.jupiter.api.Test;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.LocalPlannerContract;

class MpcTest extends LocalPlannerContract {
    @Override
    protected LocalPlanner planner(Footprint footprint, double reaction, double beat) {
        return new Mpc(footprint, LIMITS, new Mpc.Settings(8, 0.05, 0.5, 4), reaction, beat);
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
