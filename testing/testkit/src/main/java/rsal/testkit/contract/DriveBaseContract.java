package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatIllegalArgumentException;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;

/// What every [DriveBase] owes.
public abstract class DriveBaseContract extends SensorContract<Odometry, DriveBase> {
    protected DriveBaseContract() {
        super(DriveBase.class, "r1/odom");
    }

    @Test
    void standsStillUntilItIsCommanded() {
        Pose2d before = reading().odomFromBase();
        assertThat(reading().odomFromBase()).isEqualTo(before);
        assertThat(reading().velocity()).isEqualTo(Twist2d.STOP);
    }

    @Test
    void drivesStraightAhead() {
        Pose2d odomFromStart = reading().odomFromBase();
        drive(Twist2d.drive(0.4, 0), 5);
        Pose2d startFromBase = odomFromStart.inverse().compose(odometry().odomFromBase());
        assertThat(startFromBase.x()).isCloseTo(1.9, within(0.25));
        assertThat(startFromBase.y()).isCloseTo(0, within(0.2));
        assertThat(startFromBase.theta()).isCloseTo(0, within(0.15));
        assertThat(odometry().velocity().vx()).isCloseTo(0.4, within(0.05));
    }

    @Test
    void odometryIsNearlyRight() {
        Pose2d odomFromStart = reading().odomFromBase();
        Pose2d mapFromStart = truth();
        drive(Twist2d.drive(0.4, 0.3), 5);
        Pose2d byOdometry = odomFromStart.inverse().compose(odometry().odomFromBase());
        Pose2d really = mapFromStart.inverse().compose(truth());
        assertThat(byOdometry.isNear(really, 0.3, 0.3))
                .as("odometry says %s, the truth is %s", byOdometry, really)
                .isTrue();
    }

    @Test
    void turnsCounterClockwiseForPositiveRates() {
        Pose2d odomFromStart = reading().odomFromBase();
        drive(Twist2d.drive(0, 0.5), 2);
        Pose2d startFromBase = odomFromStart.inverse().compose(odometry().odomFromBase());
        assertThat(startFromBase.theta()).isCloseTo(0.9, within(0.25));
        assertThat(startFromBase.distanceTo(Pose2d.ORIGIN)).isLessThan(0.05);
    }

    @Test
    void drivesBackwardsToo() {
        Pose2d odomFromStart = reading().odomFromBase();
        drive(Twist2d.drive(-0.2, 0), 3);
        assertThat(odomFromStart.inverse().compose(odometry().odomFromBase()).x())
                .isLessThan(-0.3);
    }

    @Test
    void theNewestCommandWins() {
        DriveBase base = device();
        for (int step = 0; step < 30; step++) {
            base.command(Twist2d.drive(-0.3, 0.5));
            base.command(Twist2d.drive(0.3, 0));
            run.advance(STEP);
        }
        assertThat(odometry().velocity().vx()).isCloseTo(0.3, within(0.05));
        assertThat(odometry().velocity().omega()).isCloseTo(0, within(0.05));
    }

    @Test
    void keepsGoingForAWhileAfterACommand() {
        drive(Twist2d.drive(0.3, 0), 2);
        advance(0.3);
        assertThat(odometry().velocity().vx()).isCloseTo(0.3, within(0.05));
    }

    @Test
    void stopsByItselfWhenCommandsDryUp() {
        drive(Twist2d.drive(0.3, 0), 2);
        advance(2);
        assertThat(odometry().velocity()).isEqualTo(Twist2d.STOP);
        Pose2d stopped = odometry().odomFromBase();
        advance(1);
        assertThat(odometry().odomFromBase()).isEqualTo(stopped);
    }

    @Test
    void cutsWhatItCannotDoAndKeepsTheCurvature() {
        double forward = model().drive().maxSpeed();
        var fastest = new ArrayList<Double>();
        for (int step = 0; step < 25; step++) {
            device().command(Twist2d.drive(10 * forward, 2 * forward));
            run.advance(STEP);
            fastest.add(odometry().velocity().vx());
        }
        assertThat(fastest).allSatisfy(v -> assertThat(v).isLessThanOrEqualTo(forward * 1.05));
        Twist2d velocity = odometry().velocity();
        assertThat(velocity.vx()).isGreaterThan(forward * 0.8);
        assertThat(velocity.omega() / velocity.vx()).isCloseTo(0.2, within(0.05));
    }

    @ParameterizedTest
    @ValueSource(doubles = {Double.NaN, Double.POSITIVE_INFINITY, Double.NEGATIVE_INFINITY})
    void refusesWhatIsNotFinite(double value) {
        assertThatIllegalArgumentException().isThrownBy(() -> device().command(Twist2d.drive(value, 0)));
        assertThatIllegalArgumentException().isThrownBy(() -> device().command(Twist2d.drive(0, value)));
        advance(1);
        assertThat(odometry().velocity()).isEqualTo(Twist2d.STOP);
    }

    @Test
    void withItsMotorsOffItStandsStill() {
        needs(Capability.ENABLE);
        assertThat(device().enabled()).isTrue();
        drive(Twist2d.drive(0.3, 0), 1);
        device().enable(false);
        assertThat(device().enabled()).isFalse();
        advance(1);
        Pose2d before = odometry().odomFromBase();
        drive(Twist2d.drive(0.3, 0.3), 2);
        assertThat(odometry().odomFromBase()).isEqualTo(before);
        device().enable(true);
        advance(1);
        assertThat(odometry().odomFromBase()).as("old commands are forgotten").isEqualTo(before);
        drive(Twist2d.drive(0.3, 0), 2);
        assertThat(odometry().odomFromBase().distanceTo(before)).isGreaterThan(0.3);
    }

    @Test
    void odometryCanBeSet() {
        needs(Capability.RESET_ODOMETRY);
        drive(Twist2d.drive(0.3, 0.2), 2);
        advance(2);
        Pose2d where = truth();
        device().resetOdometry(new Pose2d(5, -3, 2));
        advance(0.5);
        assertThat(odometry().odomFromBase().isNear(new Pose2d(5, -3, 2), 0.01, 0.01))
                .isTrue();
        assertThat(truth()).isEqualTo(where);
        drive(Twist2d.drive(0.3, 0), 2);
        Pose2d driven = new Pose2d(5, -3, 2).inverse().compose(odometry().odomFromBase());
        assertThat(driven.x()).isBetween(0.3, 0.8);
        assertThat(driven.y()).isCloseTo(0, within(0.1));
    }

    @Test
    void aWallStopsItAndItSaysSo() {
        needs(Capability.WALLS);
        simulation().place("r1", WORLD.pose('w', 180));
        advance(0.5);
        simulation()
                .place(
                        "r1",
                        new Pose2d(WORLD.place('w').x() - 1, WORLD.place('w').y(), 0));
        drive(Twist2d.drive(0.4, 0), 6);
        assertThat(odometry().stalled()).isTrue();
        assertThat(truth().x()).isLessThan(WORLD.grid().width() * WORLD.grid().resolution() - 0.25 - 0.1);
        drive(Twist2d.drive(-0.2, 0), 3);
        assertThat(odometry().stalled()).isFalse();
    }

    private Odometry odometry() {
        return device().latest().orElseThrow().value();
    }
}
