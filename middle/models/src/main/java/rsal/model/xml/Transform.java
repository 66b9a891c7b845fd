package rsal.model.xml;

import rsal.data.Point2d;

/// Where a frame is in another one: a rotation and then a shift [m], as URDF's `origin` has it.
///
/// @param r rows of the rotation matrix
public record Transform(double[][] r, double x, double y, double z) {
    /// Where the frames are the same.
    public static final Transform NONE = of(new double[] {0, 0, 0}, new double[] {0, 0, 0});

    /// A point in three dimensions [m].
    public record Point(double x, double y, double z) {
        /// As seen from above.
        public Point2d flat() {
            return new Point2d(x, y);
        }
    }

    /// @param rpy turns around fixed axes: x, then y, then z (roll, pitch, yaw) [rad]
    public static Transform of(double[] xyz, double[] rpy) {
        double cr = Math.cos(rpy[0]);
        double sr = Math.sin(rpy[0]);
        double cp = Math.cos(rpy[1]);
        double sp = Math.sin(rpy[1]);
        double cy = Math.cos(rpy[2]);
        double sy = Math.sin(rpy[2]);
        return new Transform(
                new double[][] {
                    {cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr},
                    {sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr},
                    {-sp, cp * sr, cp * cr}
                },
                xyz[0],
                xyz[1],
                xyz[2]);
    }

    /// @param q a rotation as a quaternion x, y, z, w, of any length but 0
    public static Transform ofQuaternion(double[] xyz, double[] q) {
        double norm = Math.sqrt(q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3]);
        double a = q[0] / norm;
        double b = q[1] / norm;
        double c = q[2] / norm;
        double d = q[3] / norm;
        return new Transform(
                new double[][] {
                    {1 - 2 * (b * b + c * c), 2 * (a * b - c * d), 2 * (a * c + b * d)},
                    {2 * (a * b + c * d), 1 - 2 * (a * a + c * c), 2 * (b * c - a * d)},
                    {2 * (a * c - b * d), 2 * (b * c + a * d), 1 - 2 * (a * a + b * b)}
                },
                xyz[0],
                xyz[1],
                xyz[2]);
    }

    /// Of an element with an `origin`, which may be left out.
    public static Transform of(XmlElement element) {
        return element.first("origin")
                .map(origin -> of(origin.numbers("xyz", 0, 0, 0), origin.numbers("rpy", 0, 0, 0)))
                .orElse(NONE);
    }

    /// First this one, then one in its frame.
    public Transform compose(Transform next) {
        var product = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                for (int k = 0; k < 3; k++) {
                    product[i][j] += r[i][k] * next.r[k][j];
                }
            }
        }
        Point shift = apply(next.x, next.y, next.z);
        return new Transform(product, shift.x, shift.y, shift.z);
    }

    /// Where the outer frame is in the inner one.
    public Transform inverse() {
        var turned = new double[3][3];
        for (int i = 0; i < 3; i++) {
            for (int j = 0; j < 3; j++) {
                turned[i][j] = r[j][i];
            }
        }
        Point shift = new Transform(turned, 0, 0, 0).apply(-x, -y, -z);
        return new Transform(turned, shift.x, shift.y, shift.z);
    }

    /// Where a point of the inner frame is in the outer one [m].
    public Point apply(double px, double py, double pz) {
        return new Point(
                r[0][0] * px + r[0][1] * py + r[0][2] * pz + x,
                r[1][0] * px + r[1][1] * py + r[1][2] * pz + y,
                r[2][0] * px + r[2][1] * py + r[2][2] * pz + z);
    }

    /// Where its x axis points, as seen from above [rad].
    public double heading() {
        return Math.atan2(r[1][0], r[0][0]);
    }

    /// How much an axis of this frame points upwards, −1 to 1.
    public double upwards(double[] axis) {
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        return length == 0 ? 0 : (r[2][0] * axis[0] + r[2][1] * axis[1] + r[2][2] * axis[2]) / length;
    }
}
