package rsal.data;

import java.util.Locale;

/// Where a frame is, seen from its parent: x, y [m] and heading [rad] in [-π, π). Variables name both frames,
/// parent first (`mapFromBase`), so that a chain checks itself by eye:
/// `mapFromLaser = mapFromBase.compose(baseFromLaser)`.
public record Pose2d(double x, double y, double theta) {
    public static final Pose2d ORIGIN = new Pose2d(0, 0, 0);

    public Pose2d {
        theta = Angles.wrap(theta);
    }

    /// @param degrees heading as people type it
    public static Pose2d ofDegrees(double x, double y, double degrees) {
        return new Pose2d(x, y, Math.toRadians(degrees));
    }

    /// The place `range` [m] away in direction `bearing` [rad], looking that way.
    public static Pose2d polar(double range, double bearing) {
        return new Pose2d(range * Math.cos(bearing), range * Math.sin(bearing), bearing);
    }

    /// `aFromB.compose(bFromC)` is `aFromC`.
    public Pose2d compose(Pose2d next) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        return new Pose2d(
                x + cos * next.x - sin * next.y, //
                y + sin * next.x + cos * next.y,
                theta + next.theta);
    }

    /// `aFromB.inverse()` is `bFromA`.
    public Pose2d inverse() {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        return new Pose2d(-cos * x - sin * y, sin * x - cos * y, -theta);
    }

    /// `aFromB.transform(pointInB)` is the same point in `a`.
    public Point2d transform(Point2d point) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        return new Point2d(x + cos * point.x() - sin * point.y(), y + sin * point.x() + cos * point.y());
    }

    public Point2d position() {
        return new Point2d(x, y);
    }

    /// Distance of the positions [m]; headings do not count.
    public double distanceTo(Pose2d other) {
        return Math.hypot(other.x - x, other.y - y);
    }

    /// Direction of a point as this frame sees it [rad]: 0 is straight ahead.
    public double bearingTo(Point2d point) {
        return Angles.wrap(Math.atan2(point.y() - y, point.x() - x) - theta);
    }

    /// The pose between this and another one, straight and by the shorter turn.
    ///
    /// @param share of the way, 0 (here) to 1 (there)
    public Pose2d towards(Pose2d there, double share) {
        return new Pose2d(
                x + share * (there.x - x),
                y + share * (there.y - y),
                theta + share * Angles.difference(theta, there.theta));
    }

    public boolean isNear(Pose2d other, double meters, double radians) {
        return distanceTo(other) <= meters && Math.abs(Angles.difference(theta, other.theta)) <= radians;
    }

    public boolean isFinite() {
        return Double.isFinite(x) && Double.isFinite(y) && Double.isFinite(theta);
    }

    /// For people, in centimeters and degrees: `(1.23, -4.50, 90°)`.
    public String rounded() {
        return String.format(Locale.ROOT, "(%.2f, %.2f, %.0f°)", x, y, Math.toDegrees(theta));
    }
}
