package rsal.sim;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;
import static rsal.sim.SimRun.robot;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.LaserScanner;
import rsal.device.SonarArray;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;

class SimSensorsTest {
    private static final int AHEAD = 90; // of beams from −90° to 90°

    private static LaserScan scan(SimRun run, String robot) {
        return run.robot(robot)
                .require(LaserScanner.class)
                .latest()
                .orElseThrow()
                .value();
    }

    @Test
    void theLaserMeasuresToTheWallFromWhereItIsMounted() {
        var run = SimRun.of(SimRun.room(6, 4), robot("r1", Models.box(), new Pose2d(2, 1.5, 0)));
        run.advance(0.1);
        LaserScan scan = scan(run, "r1");
        assertThat(scan.ranges()[AHEAD]).isCloseTo(5.9f - 2.1f, within(1e-5f));
        assertThat(scan.ranges()[0]).isCloseTo(1.4f, within(1e-5f));
        assertThat(scan.ranges()[180]).isCloseTo(2.4f, within(1e-5f));
        assertThat(scan.baseFromLaser()).isEqualTo(new Pose2d(0.1, 0, 0));
    }

    @Test
    void sonarsSeeTheNearestThingInTheirCone() {
        var run = SimRun.of(SimRun.room(6, 4), robot("r1", Models.box(), new Pose2d(2, 1.5, Math.toRadians(10))));
        run.advance(0.1);
        RangeArray sonar =
                run.robot("r1").require(SonarArray.class).latest().orElseThrow().value();
        double toTheRight = 1.4 - 0.1 * Math.cos(Math.toRadians(10)); // a ray of the cone meets the wall upright
        assertThat(sonar.ranges()[2]).isCloseTo((float) toTheRight, within(1e-5f));
    }

    @Test
    void readingsSayWhenAndInWhichFrame() {
        var run = SimRun.of(SimRun.room(6, 4), robot("r1", Models.box(), new Pose2d(2, 2, 0)));
        run.advance(0.3);
        var at = Instant.EPOCH.plusMillis(300);
        assertThat(run.base("r1").latest().orElseThrow())
                .extracting(Stamped::time, Stamped::frame)
                .containsExactly(at, "r1/odom");
        assertThat(run.robot("r1").require(LaserScanner.class).latest().orElseThrow())
                .extracting(Stamped::time, Stamped::frame)
                .containsExactly(at, "r1/laser");
        assertThat(run.robot("r1").require(SonarArray.class).latest().orElseThrow())
                .extracting(Stamped::time, Stamped::frame)
                .containsExactly(at, "r1/base_link");
    }

    @Test
    void robotsSeeEachOther() {
        var run = SimRun.of(
                SimRun.room(8, 4),
                robot("r1", Models.box(), new Pose2d(2, 2, 0)),
                robot("r2", Models.box(), new Pose2d(4, 2, Math.PI)));
        run.advance(0.1);
        assertThat(scan(run, "r1").ranges()[AHEAD]).isCloseTo(2 - 0.1f - 0.25f, within(1e-5f));
        assertThat(scan(run, "r2").ranges()[AHEAD]).isCloseTo(2 - 0.1f - 0.25f, within(1e-5f));
        assertThat(run.robot("r1")
                        .require(SonarArray.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .ranges()[0])
                .isCloseTo(2 - 0.1f - 0.25f, within(1e-5f));
        run.simulation.place("r2", new Pose2d(4, 3, 0));
        run.advance(0.1);
        assertThat(scan(run, "r1").ranges()[AHEAD]).isCloseTo(7.9f - 2.1f, within(1e-5f));
    }

    @Test
    void rangesThatCannotBeMeasuredAreInfinite() {
        var run = SimRun.of(SimRun.room(20, 0.8), robot("r1", Models.box(), new Pose2d(2, 0.4, 0)));
        run.advance(0.1);
        assertThat(scan(run, "r1").ranges()[AHEAD]).isEqualTo(Float.POSITIVE_INFINITY); // wall is farther than 8 m
        float nearest = run.robot("r1")
                .require(SonarArray.class)
                .latest()
                .orElseThrow()
                .value()
                .ranges()[1];
        assertThat(nearest).isCloseTo(0.2f, within(1e-5f));
    }

    /// As REP 117 has it: below the least -∞, above the most +∞.
    @Test
    void shownRangesAreThoseThatCanBeMeasured() {
        var exact = new NoisyRangeSensor.Noise(RangeNoise.of(0), new SplittableRandom(1));
        NoisyRangeSensor<?> sensor = sensor(exact);
        double[][] table = {
            {0.5, 0.5},
            {0.3, 0.3},
            {0.299, Float.NEGATIVE_INFINITY},
            {0, Float.NEGATIVE_INFINITY},
            {5, 5},
            {5.001, Float.POSITIVE_INFINITY},
            {Double.POSITIVE_INFINITY, Float.POSITIVE_INFINITY}
        };
        for (double[] row : table) {
            assertThat(sensor.shown(row[0], 0.3, 5)).as("%s m", row[0]).isEqualTo((float) row[1]);
        }
    }

    /// A true range below the least is never shown as a hit, whatever its error; nor is one shown out of the range.
    @Test
    void noErrorMakesAHitOfWhatCannotBeMeasured() {
        NoisyRangeSensor<?> sensor =
                sensor(new NoisyRangeSensor.Noise(new RangeNoise(0.2, 0.1, 0), new SplittableRandom(2)));
        for (int draw = 0; draw < 2000; draw++) {
            assertThat(sensor.shown(0.29, 0.3, 5)).isEqualTo(Float.NEGATIVE_INFINITY);
            assertThat(sensor.shown(5.01, 0.3, 5)).isEqualTo(Float.POSITIVE_INFINITY);
            float near = sensor.shown(0.35, 0.3, 5);
            assertThat(near == Float.NEGATIVE_INFINITY || near >= 0.3f).isTrue();
            float far = sensor.shown(4.95, 0.3, 5);
            assertThat(far == Float.POSITIVE_INFINITY || far <= 5f).isTrue();
        }
    }

    private static NoisyRangeSensor<?> sensor(NoisyRangeSensor.Noise noise) {
        Part.Sonars sonars = Models.SONARS;
        return new SimSonar(
                new DeviceInfo("r1", "sonar", "sim"), sonars, SimSonar.cones(sonars, 0.2), DeviceMount.BASE, noise);
    }

    /// From one edge of its cone to the other a sonar sees a post, and not beyond.
    @Test
    void aSonarSeesToBothEdgesOfItsCone() {
        double half = Math.toRadians(15); // of 30°
        for (double side : new double[] {1, -1}) {
            for (double beyond : new double[] {0, 2}) { // degrees
                var run = SimRun.of(SimRun.room(8, 6), robot("r1", Models.box(), new Pose2d(2, 3, 0)));
                double angle = side * (half + Math.toRadians(beyond));
                double distance = 2;
                run.simulation.add(SimThings.can(
                        "post", 2.1 + distance * Math.cos(angle), 3 + distance * Math.sin(angle), 0.02, 1));
                run.advance(0.2);
                float range = run.robot("r1")
                        .require(SonarArray.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .ranges()[0];
                if (beyond == 0) {
                    assertThat(range).as("at the edge, %s", side).isCloseTo(1.98f, within(0.01f));
                } else {
                    assertThat(range).as("%s° outside", beyond).isGreaterThan(2.1f);
                }
            }
        }
    }

    @Test
    void eachSensorHasItsOwnPeriod() {
        var slow = Models.box(Models.DRIVE, Models.laser(0, Duration.ofMillis(250)), Models.SONARS);
        var run = SimRun.of(SimRun.room(6, 4), robot("r1", slow, new Pose2d(2, 2, 0)));
        var times = new ArrayList<Long>();
        run.robot("r1")
                .require(LaserScanner.class)
                .subscribe(s -> times.add(s.time().toEpochMilli()));
        run.advance(1.2);
        assertThat(times).containsExactly(100L, 400L, 600L, 900L, 1100L);
    }

    @Test
    void noiseHasTheModelsDeviation() {
        var noisy = Models.box(Models.DRIVE, Models.laser(0.02, Duration.ofMillis(100)));
        var run = SimRun.of(SimRun.room(6, 4), robot("r1", noisy, new Pose2d(2, 2, 0)));
        double truth = 5.9 - 2.1;
        double[] sums = new double[3];
        run.robot("r1").require(LaserScanner.class).subscribe(s -> {
            double error = s.value().ranges()[AHEAD] - truth;
            sums[0]++;
            sums[1] += error;
            sums[2] += error * error;
        });
        run.advance(1000);
        assertThat(sums[0]).isEqualTo(10_000);
        assertThat(sums[1] / sums[0]).isCloseTo(0, within(0.001));
        assertThat(Math.sqrt(sums[2] / sums[0])).isCloseTo(0.02, within(0.0005));
    }
}
