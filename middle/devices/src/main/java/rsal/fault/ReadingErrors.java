package rsal.fault;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Perturbable;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Rep117;

/// Readings with errors in them. What was not measured at all (nothing there, too close, broken) stays as it is.
final class ReadingErrors {
    private ReadingErrors() {}

    /// How wrong the next thing is that is measured.
    interface Miss {
        /// Away from what measures, of poses ahead [m].
        double range();

        /// To the left, of poses only [m].
        double left();

        /// To the left [rad].
        double angle();

        static Miss of(Fault.Biased bias) {
            return new Miss() {
                @Override
                public double range() {
                    return bias.range();
                }

                @Override
                public double left() {
                    return 0;
                }

                @Override
                public double angle() {
                    return bias.angle();
                }
            };
        }

        static Miss of(Fault.Noisy noise, RandomGenerator random) {
            return new Miss() {
                @Override
                public double range() {
                    return noise.range() * random.nextGaussian();
                }

                @Override
                public double left() {
                    return range();
                }

                @Override
                public double angle() {
                    return noise.angle() * random.nextGaussian();
                }
            };
        }
    }

    /// The same kind of reading, wrong.
    @SuppressWarnings("unchecked") // each case makes what it was given
    static <T> T reading(T value, Miss miss) {
        return (T)
                switch (value) {
                    case LaserScan scan -> scan(scan, miss);
                    case RangeArray ranges -> ranges(ranges, miss);
                    case Blobs blobs -> blobs(blobs, miss);
                    case Fiducials fiducials -> fiducials(fiducials, miss);
                    case Odometry odometry ->
                        new Odometry(moved(odometry.odomFromBase(), miss), odometry.velocity(), odometry.stalled());
                    case PoseEstimate estimate -> estimate(estimate, miss);
                    case Perturbable<?> other -> other.withError(miss.range(), miss.left(), miss.angle());
                    default -> throw new IllegalArgumentException("Nothing is measured in '%s'.".formatted(value));
                };
    }

    private static LaserScan scan(LaserScan scan, Miss miss) {
        return new LaserScan(
                scan.baseFromLaser(),
                scan.angleMin(),
                scan.angleIncrement(),
                scan.rangeMin(),
                scan.rangeMax(),
                ranges(scan.ranges(), scan.rangeMin(), scan.rangeMax(), miss));
    }

    private static RangeArray ranges(RangeArray array, Miss miss) {
        return new RangeArray(
                array.baseFromSensors(),
                array.fieldOfView(),
                array.rangeMin(),
                array.rangeMax(),
                ranges(array.ranges(), array.rangeMin(), array.rangeMax(), miss));
    }

    private static float[] ranges(float[] right, double min, double max, Miss miss) {
        float[] wrong = right.clone();
        for (int i = 0; i < wrong.length; i++) {
            if (Rep117.isHit(right[i], min, max)) {
                double range = right[i] + miss.range();
                wrong[i] =
                        range < min ? Float.NEGATIVE_INFINITY : range > max ? Float.POSITIVE_INFINITY : (float) range;
            }
        }
        return wrong;
    }

    private static Blobs blobs(Blobs right, Miss miss) {
        var wrong = new ArrayList<Blob>();
        for (Blob blob : right.blobs()) {
            blob(right, blob, miss).ifPresent(wrong::add);
        }
        wrong.sort(Comparator.comparingInt(Blob::left));
        return new Blobs(right.baseFromCamera(), right.width(), right.height(), right.fieldOfView(), wrong);
    }

    /// Empty when its middle is no longer in the image.
    private static Optional<Blob> blob(Blobs image, Blob blob, Miss miss) {
        double x = image.column(image.bearing(blob) + miss.angle());
        double range = Math.max(0, blob.range() + miss.range());
        if (!(x >= 0 && x < image.width())) {
            return Optional.empty();
        }
        long columns = Math.round(x - blob.x());
        int left = Math.clamp(blob.left() + columns, 0, image.width() - 1);
        int right = Math.clamp(blob.right() + columns, left + 1, image.width());
        long area = Math.max(1, (long) blob.area() * (right - left) / (blob.right() - blob.left()));
        return Optional.of(new Blob(
                blob.color(), left, blob.top(), right, blob.bottom(), x, blob.y(), Math.toIntExact(area), range));
    }

    private static Fiducials fiducials(Fiducials right, Miss miss) {
        Pose2d finderFromBase = right.baseFromFinder().inverse();
        List<Fiducial> wrong = right.fiducials().stream()
                .map(one -> new Fiducial(
                        one.id(),
                        right.baseFromFinder().compose(fiducial(finderFromBase.compose(one.baseFromFiducial()), miss))))
                .sorted(Comparator.comparingDouble(one -> right.baseFromFinder().distanceTo(one.baseFromFiducial())))
                .toList();
        return new Fiducials(right.baseFromFinder(), right.fieldOfView(), right.rangeMax(), wrong);
    }

    /// Turned with the direction that it is seen in.
    private static Pose2d fiducial(Pose2d finderFromFiducial, Miss miss) {
        double angle = miss.angle();
        double range = Math.max(0, Pose2d.ORIGIN.distanceTo(finderFromFiducial) + miss.range());
        double bearing = Pose2d.ORIGIN.bearingTo(finderFromFiducial.position());
        Pose2d there = Pose2d.polar(range, bearing + angle);
        return new Pose2d(there.x(), there.y(), finderFromFiducial.theta() + angle);
    }

    private static PoseEstimate estimate(PoseEstimate right, Miss miss) {
        return right.moved(step(miss));
    }

    private static Pose2d moved(Pose2d right, Miss miss) {
        return right.compose(step(miss));
    }

    private static Pose2d step(Miss miss) {
        return new Pose2d(miss.range(), miss.left(), miss.angle());
    }
}
