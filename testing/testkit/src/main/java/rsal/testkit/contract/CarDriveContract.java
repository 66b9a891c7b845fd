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

/// What a [DriveBase] owes besides when it steers like a car: this one turns in a circle of 0.6 m radius, drives
/// up to 0.8 m/s and up to 0.2 m/s backward.
public abstract class CarDriveContract extends SensorContract<Odometry, DriveBase> {
    private static final Steering.Car CAR = new Steering.Car(0.3, Math.atan2(0.3, 0.6));

    protected CarDriveContract() {
        super(DriveBase.class, "r1/odom");
    }

    @Override
    protected RobotModel model() {
        Axis forward = new Axis(new Interval(-0.2, 0.8), Interval.around0(1));
        var drive = new Drive(CAR, forward, Axis.NONE, Axis.symmetric(2, 8), new OdometryNoise(0, 0, 0));
        return super.model().with(drive);
    }

    @Test
    void doesNotTurnInPlace() {
        Pose2d before = reading().odomFromBase();
        drive(Twist2d.drive(0, 1), 3);
        assertThat(odometry().odomFromBase()).isEqualTo(before);
        assertThat(odometry().velocity()).isEqualTo(Twist2d.STOP);
    }

    @Test
    void turnsNoTighterThanItsWheelsLetIt() {
        Pose2d odomFromStart = reading().odomFromBase();
        double seconds = Math.PI / 2 * 0.6 / 0.3; // a quarter of a circle
        drive(Twist2d.drive(0.3, 2), seconds);
        Pose2d startFromBase = odomFromStart.inverse().compose(odometry().odomFromBase());
        assertThat(startFromBase.theta()).isCloseTo(Math.PI / 2, within(0.25));
        assertThat(startFromBase.x()).isCloseTo(0.6, within(0.12));
        assertThat(startFromBase.y()).isCloseTo(0.6, within(0.15));
        assertThat(odometry().velocity().omega()).isCloseTo(0.5, within(0.02));
    }

    @Test
    void widerBendsAreDrivenAsTheyAreAsked() {
        drive(Twist2d.drive(0.4, 0.2), 3);
        assertThat(odometry().velocity().vx()).isCloseTo(0.4, within(0.03));
        assertThat(odometry().velocity().omega()).isCloseTo(0.2, within(0.02));
    }

    @Test
    void isSlowerBackward() {
        drive(Twist2d.drive(-0.8, 0), 3);
        assertThat(odometry().velocity().vx()).isCloseTo(-0.2, within(0.02));
    }

    private Odometry odometry() {
        return device().latest().orElseThrow().value();
    }
}
