package rsal.behavior;

import java.time.Instant;
import java.util.Arrays;
import rsal.data.Footprint;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// What a robot sees, put together for a test.
final class Scene {
    /// A Pioneer 2-DX.
    static final Footprint BODY = Footprint.box(0.44, 0.38, new Point2d(-0.04, 0));

    private final float[] ranges = new float[Surroundings.SECTORS];
    private Pose2d odomFromBase = Pose2d.ORIGIN;

    private Scene() {
        Arrays.fill(ranges, Float.POSITIVE_INFINITY);
    }

    static Scene open() {
        return new Scene();
    }

    /// A wall along the line of a heading's foot: everything at least this far away in that direction.
    Scene wall(double degrees, double distance) {
        for (int i = 0; i < ranges.length; i++) {
            double across = Math.cos(Surroundings.direction(i) - Math.toRadians(degrees));
            if (across > 0.05) {
                ranges[i] = Math.min(ranges[i], (float) (distance / across));
            }
        }
        return this;
    }

    /// Something small.
    Scene thing(double degrees, double distance) {
        ranges[Surroundings.sector(Math.toRadians(degrees))] = (float) distance;
        return this;
    }

    /// No wall between two directions, counter-clockwise.
    Scene gap(double fromDegrees, double toDegrees) {
        return fill(fromDegrees, toDegrees, Float.POSITIVE_INFINITY);
    }

    /// Nobody looks between two directions, counter-clockwise.
    Scene unseen(double fromDegrees, double toDegrees) {
        return fill(fromDegrees, toDegrees, Float.NaN);
    }

    Scene at(Pose2d pose) {
        odomFromBase = pose;
        return this;
    }

    Percept percept() {
        return new Percept(
                Instant.EPOCH, new Odometry(odomFromBase, Twist2d.STOP, false), new Surroundings(ranges.clone()));
    }

    private Scene fill(double fromDegrees, double toDegrees, float range) {
        for (double degrees = fromDegrees; degrees <= toDegrees; degrees += 1) {
            ranges[Surroundings.sector(Math.toRadians(degrees))] = range;
        }
        return this;
    }
}
