package rsal.model.urdf;

import rsal.data.Point2d;

/// Where a frame is in another one: a rotation and then a shift [m], as URDF's `origin` has it.
///
/// @param r rows of the rotation matrix
record Transform(double[][] r, double x, double y, double z) {
    static final Transform NONE = of(new double[] {0, 0, 0}, new double[] {0, 0, 0});

    /// A point in three dimensions [m].
    record Point(double x, double y, double z) {
        Point2d flat() {
            return new Point2d(x, y);
        }
    }

    /// @param rpy turns around fixed axes: x, then y, then z (roll, pitch, yaw) [rad]
    static Transform of(double[] xyz, double[] rpy) {
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

    /// Of an element with an `origin`, which may be left out.
    static Transform of(XmlElement element) {
        return element.first("origin")
                .map(origin -> of(origin.numbers("xyz", 0, 0, 0), origin.numbers("rpy", 0, 0, 0)))
                .orElse(NONE);
    }

    Transform compose(Transform next) {
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

    Point apply(double px, double py, double pz) {
        return new Point(
                r[0][0] * px + r[0][1] * py + r[0][2] * pz + x,
                r[1][0] * px + r[1][1] * py + r[1][2] * pz + y,
                r[2][0] * px + r[2][1] * py + r[2][2] * pz + z);
    }

    /// Where its x axis points, as seen from above [rad].
    double heading() {
        return Math.atan2(r[1][0], r[0][0]);
    }

    /// How much an axis of this frame points upwards, −1 to 1.
    double upwards(double[] axis) {
        double length = Math.sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]);
        return length == 0 ? 0 : (r[2][0] * axis[0] + r[2][1] * axis[1] + r[2][2] * axis[2]) / length;
    }
}
