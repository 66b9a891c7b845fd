package rsal.fault;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.OptionalInt;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Covariance2d;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Navigator;
import rsal.fault.Fault.Biased;
import rsal.fault.Fault.Dead;
import rsal.fault.Fault.Frozen;
import rsal.fault.Fault.Noisy;

class SensorFaultsTest {
    private static final double DEGREE = Math.toRadians(1);

    private static SplittableRandom random() {
        return new SplittableRandom(1);
    }

    private static <T> Stamped<T> at(int second, T value) {
        return new Stamped<>(Instant.EPOCH.plusSeconds(second), "frame", value);
    }

    /// What a sensor with a fault shows of one reading.
    private static <T> T shown(Fault.OfSensor fault, T value) {
        var faults = new SensorFaults<T>();
        faults.add(fault, random());
        return faults.shown(at(1, value)).orElseThrow().value();
    }

    private static LaserScan scan(float... ranges) {
        return new LaserScan(Pose2d.ORIGIN, 0, 0.1, 0.05, 8, ranges);
    }

    @Test
    void withoutFaultsTheReadingItselfIsShown() {
        Stamped<LaserScan> reading = at(1, scan(1, 2));
        assertThat(new SensorFaults<LaserScan>().shown(reading).orElseThrow()).isSameAs(reading);
    }

    @Test
    void aBiasedLaserMeasuresThatMuchMore() {
        assertThat(shown(new Biased(0.1, 0), scan(1, 7.95f, 0.3f)).ranges())
                .containsExactly(1.1f, Float.POSITIVE_INFINITY, 0.4f);
        assertThat(shown(new Biased(-0.3, 0), scan(1, 0.3f)).ranges()).containsExactly(0.7f, Float.NEGATIVE_INFINITY);
    }

    @Test
    void whatWasNotMeasuredHasNoError() {
        float[] none = {Float.POSITIVE_INFINITY, Float.NEGATIVE_INFINITY, Float.NaN};
        assertThat(shown(new Biased(0.1, 0), scan(none)).ranges()).containsExactly(none);
        assertThat(shown(new Biased(0.1, 0), new LaserScan(Pose2d.ORIGIN, 0, 0.1, 0, 8, new float[2]))
                        .ranges())
                .containsExactly(0, 0);
        assertThat(shown(new Noisy(0.1, 0), scan(none)).ranges()).containsExactly(none);
    }

    @Test
    void theReadingItselfStaysRight() {
        LaserScan right = scan(1, 2);
        shown(new Biased(0.1, 0), right);
        assertThat(right.ranges()).containsExactly(1, 2);
    }

    @Test
    void aBiasedSonarToo() {
        var sonars = new RangeArray(List.of(Pose2d.ORIGIN, Pose2d.ORIGIN), 0.5, 0.1, 5, new float[] {2, 4});
        assertThat(shown(new Biased(-0.5, 0), sonars).ranges()).containsExactly(1.5f, 3.5f);
    }

    @Test
    void aNoisyLaserHasTheVarianceThatWasAskedFor() {
        float[] ranges = new float[10_000];
        Arrays.fill(ranges, 4);
        float[] noisy = shown(new Noisy(0.2, 0), scan(ranges)).ranges();
        double sum = 0;
        double squares = 0;
        for (float range : noisy) {
            sum += range - 4;
            squares += (range - 4) * (range - 4);
        }
        assertThat(sum / noisy.length).isCloseTo(0, within(0.01)); // 5 standard errors
        assertThat(squares / noisy.length).isCloseTo(0.04, within(0.003));
    }

    @Test
    void aFrozenSensorRepeatsItsLastReadingAsIfItWereNew() {
        var faults = new SensorFaults<String>();
        faults.shown(at(1, "one"));
        var frozen = faults.add(new Frozen(), random());
        assertThat(faults.shown(at(2, "two"))).contains(at(2, "one"));
        assertThat(faults.shown(at(3, "three"))).contains(at(3, "one"));
        frozen.cancel();
        assertThat(faults.shown(at(4, "four"))).contains(at(4, "four"));
    }

    @Test
    void oneThatFreezesBeforeItsFirstReadingRepeatsThat() {
        var faults = new SensorFaults<String>();
        faults.add(new Frozen(), random());
        assertThat(faults.shown(at(1, "one"))).contains(at(1, "one"));
        assertThat(faults.shown(at(2, "two"))).contains(at(2, "one"));
    }

    @Test
    void aDeadSensorShowsNothing() {
        var faults = new SensorFaults<String>();
        var dead = faults.add(new Dead(), random());
        var deadToo = faults.add(new Dead(), random());
        assertThat(faults.shown(at(1, "one"))).isEmpty();
        dead.cancel();
        assertThat(faults.shown(at(2, "two"))).isEmpty();
        deadToo.cancel();
        assertThat(faults.shown(at(3, "three"))).contains(at(3, "three"));
    }

    @Test
    void errorsAddUp() {
        var faults = new SensorFaults<LaserScan>();
        faults.add(new Biased(0.25, 0), random());
        faults.add(new Biased(0.5, 0), random());
        assertThat(faults.shown(at(1, scan(1))).orElseThrow().value().ranges()).containsExactly(1.75f);
    }

    @Test
    void aBiasedCameraSeesBlobsFartherAwayAndMoreToTheLeft() {
        var blob = new Blob(Rgb.parse("#ff0000").orElseThrow(), 38, 10, 42, 20, 40, 15, 40, 2);
        var atTheEdge = new Blob(Rgb.parse("#00ff00").orElseThrow(), 0, 10, 4, 20, 2, 15, 40, 2);
        var image = new Blobs(Pose2d.ORIGIN, 80, 60, 80 * DEGREE, List.of(atTheEdge, blob));
        Blobs wrong = shown(new Biased(0.5, 10 * DEGREE), image);
        assertThat(wrong.blobs()).singleElement().satisfies(one -> {
            assertThat(one.left()).isEqualTo(28);
            assertThat(one.right()).isEqualTo(32);
            assertThat(one.area()).isEqualTo(40);
            assertThat(one.range()).isEqualTo(2.5);
            assertThat(wrong.bearing(one)).isCloseTo(10 * DEGREE, within(1e-9));
        });
    }

    @Test
    void aBiasedFinderSeesMarkersFartherAwayAndMoreToTheLeft() {
        var marker = new Fiducial(OptionalInt.of(7), new Pose2d(2.2, 0, Math.PI));
        var seen = new Fiducials(new Pose2d(0.2, 0, 0), 3, 8, List.of(marker));
        Fiducial wrong = shown(new Biased(1, 90 * DEGREE), seen).fiducials().getFirst();
        assertThat(wrong.id()).hasValue(7);
        assertThat(wrong.baseFromFiducial().isNear(new Pose2d(0.2, 3, -90 * DEGREE), 1e-9, 1e-9))
                .as(wrong.toString())
                .isTrue();
    }

    @Test
    void aBiasedPoseIsFartherAheadAndTurned() {
        var odometry = new Odometry(new Pose2d(1, 1, 90 * DEGREE), Twist2d.STOP, false);
        Pose2d wrong = new Pose2d(1, 1.5, 100 * DEGREE);
        var bias = new Biased(0.5, 10 * DEGREE);
        assertThat(shown(bias, odometry).odomFromBase().isNear(wrong, 1e-9, 1e-9))
                .isTrue();
        PoseEstimate estimate =
                shown(bias, PoseEstimate.of(odometry.odomFromBase(), Covariance2d.ofDeviations(0.1, 0.1, 0.1)));
        assertThat(estimate.mapFromBase().isNear(wrong, 1e-9, 1e-9)).isTrue();
        assertThat(estimate.hypotheses().getFirst().mapFromBase()).isEqualTo(estimate.mapFromBase());
    }

    @Test
    void aNoisyPoseIsWrongInAllDirections() {
        var faults = new SensorFaults<Odometry>();
        faults.add(new Noisy(0.1, 2 * DEGREE), random());
        var right = new Odometry(new Pose2d(3, -2, 1), Twist2d.STOP, false);
        double along = 0;
        double across = 0;
        double turned = 0;
        for (int i = 0; i < 5000; i++) {
            Pose2d wrong = faults.shown(at(i, right)).orElseThrow().value().odomFromBase();
            Pose2d error = right.odomFromBase().inverse().compose(wrong);
            along += error.x() * error.x() / 5000;
            across += error.y() * error.y() / 5000;
            turned += error.theta() * error.theta() / 5000;
        }
        assertThat(Math.sqrt(along)).isCloseTo(0.1, within(0.005));
        assertThat(Math.sqrt(across)).isCloseTo(0.1, within(0.005));
        assertThat(Math.sqrt(turned)).isCloseTo(2 * DEGREE, within(0.1 * DEGREE));
    }

    @Test
    void notEverySensorCanHaveEveryFault() {
        assertThat(SensorFaults.refusal(LaserScanner.class, new Noisy(0.1, 0))).isEmpty();
        assertThat(SensorFaults.refusal(BlobFinder.class, new Biased(0, 0.1))).isEmpty();
        assertThat(SensorFaults.refusal(DriveBase.class, new Frozen())).isEmpty();
        assertThat(SensorFaults.refusal(Bumper.class, new Dead())).isEmpty();
        assertThat(SensorFaults.refusal(Battery.class, new Biased(1, 0)))
                .get()
                .asString()
                .contains("no ranges");
        assertThat(SensorFaults.refusal(LaserScanner.class, new Biased(0, 0.1)))
                .get()
                .asString()
                .contains("ranges only");
        assertThat(SensorFaults.refusal(Navigator.class, new Dead())).contains("It is not a sensor.");
    }
}
