package rsal.data;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.List;
import java.util.Random;
import org.junit.jupiter.api.Test;
import rsal.data.Blobs.Blob;

class BlobsTest {
    private static Blob at(double x, double range) {
        return new Blob(Rgb.of(0xff0000), (int) x, 20, (int) x + 1, 40, x, 30, 20, range);
    }

    @Test
    void theMiddleOfTheImageIsAheadAndItsLeftEdgeIsToTheLeft() {
        var blobs = new Blobs(Pose2d.ORIGIN, 80, 60, Math.toRadians(90), List.of());
        assertThat(blobs.bearing(at(40, 1))).isZero();
        assertThat(blobs.bearing(at(0, 1))).isCloseTo(Math.toRadians(45), within(1e-12));
        assertThat(blobs.bearing(at(80, 1))).isCloseTo(Math.toRadians(-45), within(1e-12));
    }

    @Test
    void whereABlobIsFollowsFromItsColumnAndRange() {
        for (long seed = 0; seed < 500; seed++) {
            var random = new Random(seed);
            var camera = new Pose2d(random.nextGaussian(), random.nextGaussian(), 6 * random.nextDouble());
            double fieldOfView = 0.1 + 3 * random.nextDouble();
            var blobs = new Blobs(camera, 1 + random.nextInt(1000), 60, fieldOfView, List.of());
            double bearing = fieldOfView * (random.nextDouble() - 0.5);
            double range = 5 * random.nextDouble();
            double column = blobs.column(bearing);
            assertThat(column).as("seed %d", seed).isBetween(0.0, (double) blobs.width());
            Point2d place = blobs.baseFromBlob(at(column, range)).orElseThrow();
            assertThat(place.distanceTo(camera.position())).as("seed %d", seed).isCloseTo(range, within(1e-9));
            assertThat(Angles.difference(camera.bearingTo(place), range < 1e-6 ? camera.bearingTo(place) : bearing))
                    .as("seed %d", seed)
                    .isCloseTo(0, within(1e-6));
        }
    }

    @Test
    void withoutARangeItIsNotKnownWhereABlobIs() {
        var blobs = new Blobs(Pose2d.ORIGIN, 80, 60, 1, List.of());
        assertThat(blobs.baseFromBlob(at(40, Double.NaN))).isEmpty();
    }
}
