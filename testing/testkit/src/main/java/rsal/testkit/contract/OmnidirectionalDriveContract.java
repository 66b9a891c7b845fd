package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import rsal.data.Interval;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Axis;
import rsal.robot.RobotModel.Drive;
import rsal.robot.RobotModel.OdometryNoise;
import rsal.robot.RobotModel.Steering;

/// What a [DriveBase] owes besides when it moves in every direction: this one up to 0.5 m/s to the left and
/// 0.3 m/s to the right.
public abstract class OmnidirectionalDriveContract extends SensorContract<Odometry, DriveBase> {
    protected OmnidirectionalDriveContract() {
        super(DriveBase.class, "r1/odom");
    }

    @Override
    protected RobotModel model() {
        Axis sideways = new Axis(new Interval(-0.3, 0.5), Interval.around0(1));
        var drive = new Drive(
                new Steering.Omnidirectional(),
                Axis.symmetric(1, 1),
                sideways,
                Axis.symmetric(2, 4),
                new OdometryNoise(0, 0, 0));
        return super.model().with(drive);
    }

    @Test
    void drivesSidewaysWithoutTurning() {
        Pose2d odomFromStart = reading().odomFromBase();
        drive(new Twist2d(0, -0.25, 0), 4);
        Pose2d startFromBase = odomFromStart.inverse().compose(odometry().odomFromBase());
        assertThat(startFromBase.y()).isCloseTo(-0.95, within(0.1));
        assertThat(startFromBase.x()).isCloseTo(0, within(0.05));
        assertThat(startFromBase.theta()).isCloseTo(0, within(0.05));
        assertThat(odometry().velocity().vy()).isCloseTo(-0.25, within(0.03));
    }

    @Test
    void doesAllAtOnce() {
        Pose2d before = reading().odomFromBase();
        drive(new Twist2d(0.3, 0.2, 0.3), 2);
        Twist2d velocity = odometry().velocity();
        assertThat(velocity.vx()).isCloseTo(0.3, within(0.05));
        assertThat(velocity.vy()).isCloseTo(0.2, within(0.05));
        assertThat(velocity.omega()).isCloseTo(0.3, within(0.05));
        assertThat(before.distanceTo(odometry().odomFromBase())).isBetween(0.4, 0.8);
    }

    @Test
    void isCutToItsLimitOnEachSideKeepingItsDirection() {
        drive(new Twist2d(0, -3, 0), 2);
        assertThat(odometry().velocity().vy()).isCloseTo(-0.3, within(0.03));
        drive(new Twist2d(0, 3, 0), 1.5);
        assertThat(odometry().velocity().vy()).isCloseTo(0.5, within(0.03));
        drive(new Twist2d(3, -3, 0), 2);
        assertThat(odometry().velocity().vx()).isCloseTo(0.3, within(0.03));
        assertThat(odometry().velocity().vy()).isCloseTo(-0.3, within(0.03));
    }

    @Test
    void aWallAtItsSideStopsIt() {
        needs(Capability.WALLS);
        drive(new Twist2d(0, -0.4, 0), 12);
        assertThat(odometry().stalled()).isTrue();
        assertThat(truth().y()).isGreaterThan(0.25);
    }

    private Odometry odometry() {
        return device().latest().orElseThrow().value();
    }
}
