package rsal.sim.world;

import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// A robot's footprint, placed somewhere: a convex polygon as corners and as half planes, of which each edge's
/// outward normal and offset make one. Flat arrays, as all rays and collision checks look at them.
public final class Outline {
    private final int count;
    private final double radius;
    private final double[] bodyX;
    private final double[] bodyY;
    private final double[] bodyNormalX;
    private final double[] bodyNormalY;
    private final double[] bodyOffset;

    private Pose2d pose = Pose2d.ORIGIN;
    private double cos;
    private double sin;
    private final double[] cornerX;
    private final double[] cornerY;
    private final double[] normalX;
    private final double[] normalY;
    private final double[] offset;
    private double minX;
    private double minY;
    private double maxX;
    private double maxY;

    /// Placed at the origin.
    public Outline(Footprint footprint) {
        count = footprint.corners().size();
        radius = footprint.circumscribedRadius();
        bodyX = new double[count];
        bodyY = new double[count];
        bodyNormalX = new double[count];
        bodyNormalY = new double[count];
        bodyOffset = new double[count];
        cornerX = new double[count];
        cornerY = new double[count];
        normalX = new double[count];
        normalY = new double[count];
        offset = new double[count];
        for (int i = 0; i < count; i++) {
            Point2d from = footprint.corners().get(i);
            Point2d to = footprint.corners().get((i + 1) % count);
            double length = from.distanceTo(to);
            bodyX[i] = from.x();
            bodyY[i] = from.y();
            bodyNormalX[i] = (to.y() - from.y()) / length;
            bodyNormalY[i] = (from.x() - to.x()) / length;
            bodyOffset[i] = bodyNormalX[i] * from.x() + bodyNormalY[i] * from.y();
        }
        placeAt(Pose2d.ORIGIN);
    }

    public void placeAt(Pose2d mapFromBase) {
        pose = mapFromBase;
        cos = StrictMath.cos(pose.theta());
        sin = StrictMath.sin(pose.theta());
        minX = Double.POSITIVE_INFINITY;
        minY = Double.POSITIVE_INFINITY;
        maxX = Double.NEGATIVE_INFINITY;
        maxY = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            cornerX[i] = pose.x() + cos * bodyX[i] - sin * bodyY[i];
            cornerY[i] = pose.y() + sin * bodyX[i] + cos * bodyY[i];
            normalX[i] = cos * bodyNormalX[i] - sin * bodyNormalY[i];
            normalY[i] = sin * bodyNormalX[i] + cos * bodyNormalY[i];
            offset[i] = bodyOffset[i] + normalX[i] * pose.x() + normalY[i] * pose.y();
            minX = Math.min(minX, cornerX[i]);
            minY = Math.min(minY, cornerY[i]);
            maxX = Math.max(maxX, cornerX[i]);
            maxY = Math.max(maxY, cornerY[i]);
        }
    }

    /// Places it where another of the same footprint is.
    void copy(Outline other) {
        pose = other.pose;
        cos = other.cos;
        sin = other.sin;
        minX = other.minX;
        minY = other.minY;
        maxX = other.maxX;
        maxY = other.maxY;
        System.arraycopy(other.cornerX, 0, cornerX, 0, count);
        System.arraycopy(other.cornerY, 0, cornerY, 0, count);
        System.arraycopy(other.normalX, 0, normalX, 0, count);
        System.arraycopy(other.normalY, 0, normalY, 0, count);
        System.arraycopy(other.offset, 0, offset, 0, count);
    }

    /// Where it is: mapFromBase.
    public Pose2d pose() {
        return pose;
    }

    /// Of its heading.
    double cos() {
        return cos;
    }

    /// Of its heading.
    double sin() {
        return sin;
    }

    double x() {
        return pose.x();
    }

    double y() {
        return pose.y();
    }

    /// Of the smallest circle around the base's origin that holds it [m].
    public double radius() {
        return radius;
    }

    double minX() {
        return minX;
    }

    double minY() {
        return minY;
    }

    double maxX() {
        return maxX;
    }

    double maxY() {
        return maxY;
    }

    /// How far this is from another [m]: the largest gap along the normal of any edge (separating axes), which is
    /// at most the true distance; 0 or less when they overlap. No more is computed once it is known to reach
    /// `reach`.
    double separation(Outline other, double reach) {
        double dx = other.x() - x();
        double dy = other.y() - y();
        double circles = radius + other.radius + reach;
        if (dx * dx + dy * dy >= circles * circles) {
            return reach;
        }
        return Math.min(reach, Math.max(gapTo(other), other.gapTo(this)));
    }

    private double gapTo(Outline other) {
        double gap = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int j = 0; j < other.count; j++) {
                nearest = Math.min(nearest, normalX[i] * other.cornerX[j] + normalY[i] * other.cornerY[j]);
            }
            gap = Math.max(gap, nearest - offset[i]);
        }
        return gap;
    }

    /// As [#separation(Outline, double)], from an upright box.
    double separation(double left, double bottom, double right, double top) {
        double gap = Math.max(Math.max(left - maxX, minX - right), Math.max(bottom - maxY, minY - top));
        for (int i = 0; i < count; i++) {
            double nearest =
                    normalX[i] * (normalX[i] > 0 ? left : right) + normalY[i] * (normalY[i] > 0 ? bottom : top);
            gap = Math.max(gap, nearest - offset[i]);
        }
        return gap;
    }

    /// Way of a ray from a place to where it enters the outline [m]; 0 from inside, +∞ when it misses. Clips the
    /// ray by one half plane after the other (Cyrus and Beck 1978).
    double ray(double x, double y, double dx, double dy) {
        double enters = 0;
        double leaves = Double.POSITIVE_INFINITY;
        for (int i = 0; i < count; i++) {
            double outside = normalX[i] * x + normalY[i] * y - offset[i];
            double along = normalX[i] * dx + normalY[i] * dy;
            if (along < 0) {
                enters = Math.max(enters, -outside / along);
            } else if (along > 0) {
                leaves = Math.min(leaves, -outside / along);
            } else if (outside > 0) {
                return Double.POSITIVE_INFINITY;
            }
        }
        return enters <= leaves ? enters : Double.POSITIVE_INFINITY;
    }
}
