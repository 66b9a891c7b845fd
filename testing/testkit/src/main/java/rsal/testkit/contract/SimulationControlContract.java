package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.SimulationControl.Contact;
import rsal.device.SimulationControl.Placement;

/// What every [rsal.device.SimulationControl] owes. A system without a simulated world does not extend this.
public abstract class SimulationControlContract extends RobotBench {
    @Test
    void knowsWhereTheRobotsAre() {
        assertThat(simulation().entities()).contains("r1");
        assertThat(truth()).isEqualTo(START);
        assertThat(simulation().truth("nobody")).isEmpty();
    }

    @Test
    void theTruthMovesWithTheRobot() {
        drive(Twist2d.drive(0.4, 0), 4);
        Pose2d startFromNow = START.inverse().compose(truth());
        assertThat(startFromNow.x()).isBetween(1.2, 1.7);
        assertThat(Math.abs(startFromNow.y())).isLessThan(0.01);
    }

    @Test
    void placesARobotStandingStillAndOdometryDoesNotNotice() {
        drive(Twist2d.drive(0.4, 0), 2);
        Pose2d odomBefore = odom();
        Pose2d there = WORLD.pose('b', 45);
        assertThat(simulation().place("r1", there)).isEqualTo(new Placement.Placed());
        assertThat(truth()).isEqualTo(there);
        advance(1);
        assertThat(truth()).isEqualTo(there);
        assertThat(odom().isNear(odomBefore, 0.05, 0.05)).isTrue();
    }

    @Test
    void refusesToPlaceARobotInAWallOrOutside() {
        assertRefused("r1", new Pose2d(WORLD.grid().width() * 0.25 - 0.1, 4, 0));
        assertRefused("r1", new Pose2d(-3, 4, 0));
        assertRefused("r1", new Pose2d(Double.NaN, 4, 0));
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void refusesToPlaceNobody() {
        assertRefused("nobody", START);
    }

    @Test
    void countsATouchOnceUntilItIsOver() {
        needs(Capability.WALLS);
        simulation()
                .place(
                        "r1",
                        new Pose2d(WORLD.place('w').x() - 1, WORLD.place('w').y(), 0));
        assertThat(simulation().contacts()).isEmpty();
        drive(Twist2d.drive(0.4, 0), 6);
        assertThat(simulation().contacts()).hasSize(1);
        Contact contact = simulation().contacts().getFirst();
        assertThat(contact.robot()).isEqualTo("r1");
        assertThat(contact.other()).isEqualTo("wall");
        assertThat(contact.time()).isBetween(run.instant().minusSeconds(6), run.instant());
        drive(Twist2d.drive(-0.4, 0), 3);
        drive(Twist2d.drive(0.4, 0), 6);
        assertThat(simulation().contacts()).hasSize(2);
    }

    private void assertRefused(String entity, Pose2d place) {
        assertThat(simulation().place(entity, place))
                .isInstanceOfSatisfying(
                        Placement.Refused.class,
                        refused -> assertThat(refused.why()).isNotBlank());
    }

    private Pose2d odom() {
        return robot().require(DriveBase.class).latest().orElseThrow().value().odomFromBase();
    }
}
