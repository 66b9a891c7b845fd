package rsal.testkit.contract;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.LaserScanner;
import rsal.robot.RobotModel.Part;
import rsal.testkit.ObviousRays;

/// What every [LaserScanner] owes.
public abstract class LaserScannerContract extends SensorContract<LaserScan, LaserScanner> {
    protected LaserScannerContract() {
        super(LaserScanner.class, "r1/laser");
    }

    private Part.Laser part() {
        return (Part.Laser) java.util.Objects.requireNonNull(model().sensors().get("laser"));
    }

    @Test
    void itsScansAreThoseOfTheModelsLaser() {
        LaserScan scan = reading();
        assertThat(scan.count()).isEqualTo(part().samples());
        assertThat(scan.baseFromLaser().isNear(part().baseFromLaser(), 1e-6, 1e-6))
                .isTrue();
        assertThat(scan.angleMin()).isCloseTo(part().angleMin(), within(1e-3));
        assertThat(scan.angle(scan.count() - 1)).isCloseTo(-part().angleMin(), within(1e-2));
        assertThat(scan.rangeMin()).isCloseTo(part().rangeMin(), within(1e-3));
        assertThat(scan.rangeMax()).isCloseTo(part().rangeMax(), within(1e-3));
    }

    @Test
    void measuresTheWayToWallsAndNothingBeyondItsReach() {
        needs(Capability.TRUTH);
        assertRight(reading());
    }

    @Test
    void measuresFromWhereTheRobotIs() {
        needs(Capability.TRUTH);
        drive(Twist2d.drive(0.4, 0.4), 4);
        advance(1);
        assertRight(reading());
    }

    @Test
    void aScanOnceGivenDoesNotChange() {
        LaserScan scan = reading();
        float[] before = scan.ranges().clone();
        drive(Twist2d.drive(0, 0.5), 2);
        assertThat(scan.ranges()).isEqualTo(before);
    }

    /// Beams may be off where they graze a wall or pass a corner, so a few may differ.
    private void assertRight(LaserScan scan) {
        var rays = new ObviousRays(WORLD.grid());
        Pose2d mapFromLaser = truth().compose(scan.baseFromLaser());
        double tolerance = 5 * part().noise().deviation() + 0.03;
        int wrong = 0;
        for (int beam = 0; beam < scan.count(); beam++) {
            double range = scan.ranges()[beam];
            double real = rays.range(mapFromLaser.compose(new Pose2d(0, 0, scan.angle(beam))));
            boolean right = scan.isHit(beam)
                    ? Math.abs(range - real) <= tolerance
                    : range == Double.POSITIVE_INFINITY && real > scan.rangeMax() - tolerance;
            wrong += right ? 0 : 1;
        }
        assertThat(wrong).as("wrong beams of %d", scan.count()).isLessThanOrEqualTo(scan.count() / 25);
        assertThat(scan.ranges()).contains(Float.POSITIVE_INFINITY); // along the hall
    }
}
