package rsal.ros2.message;

import rsal.data.Pose2d;
import rsal.ros2.cdr.RosMessage;

/// Where a frame is in another one, in space (`geometry_msgs/Transform`).
///
/// @param x [m]
/// @param y [m]
/// @param z [m]
/// @param rotation a unit quaternion
public record FrameTransform(double x, double y, double z, Quaternion rotation) {
    public static final FrameTransform NONE = new FrameTransform(0, 0, 0, new Quaternion(0, 0, 0, 1));

    /// Where the optical frame of a camera (x to the right, y down, z ahead) is in one with x ahead (REP 103).
    public static final FrameTransform OPTICAL = new FrameTransform(0, 0, 0, new Quaternion(-0.5, 0.5, -0.5, 0.5));

    /// @param message `geometry_msgs/Transform` or `geometry_msgs/Pose`
    /// @param translation name of its first field
    /// @param rotation name of its second field
    public static FrameTransform of(RosMessage message, String translation, String rotation) {
        RosMessage place = message.message(translation);
        RosMessage turned = message.message(rotation);
        return new FrameTransform(
                place.number("x"),
                place.number("y"),
                place.number("z"),
                new Quaternion(turned.number("x"), turned.number("y"), turned.number("z"), turned.number("w")).unit());
    }

    /// First the other one, then this.
    public FrameTransform compose(FrameTransform other) {
        double[] moved = rotation.rotated(other.x, other.y, other.z);
        return new FrameTransform(x + moved[0], y + moved[1], z + moved[2], rotation.times(other.rotation));
    }

    public FrameTransform inverse() {
        Quaternion back = rotation.conjugate();
        double[] moved = back.rotated(-x, -y, -z);
        return new FrameTransform(moved[0], moved[1], moved[2], back);
    }

    /// Between this one and another: positions on a line, rotations on the shortest way.
    ///
    /// @param share of the way to the other one, 0 to 1
    public FrameTransform interpolated(FrameTransform other, double share) {
        return new FrameTransform(
                x + share * (other.x - x),
                y + share * (other.y - y),
                z + share * (other.z - z),
                rotation.interpolated(other.rotation, share));
    }

    /// In the plane.
    public static FrameTransform of(Pose2d pose) {
        double half = pose.theta() / 2;
        return new FrameTransform(pose.x(), pose.y(), 0, new Quaternion(0, 0, Math.sin(half), Math.cos(half)));
    }

    /// As seen from above: the heading is that of the x axis.
    public Pose2d planar() {
        double[] ahead = rotation.rotated(1, 0, 0);
        return new Pose2d(x, y, Math.atan2(ahead[1], ahead[0]));
    }

    /// Whether its z axis points down.
    public boolean isUpsideDown() {
        return rotation.rotated(0, 0, 1)[2] < 0;
    }

    public boolean isFinite() {
        return Double.isFinite(x + y + z + rotation.x() + rotation.y() + rotation.z() + rotation.w());
    }

    /// A rotation in space.
    public record Quaternion(double x, double y, double z, double w) {
        private static final double NEARLY_EQUAL = 1e-6; // sine of half an angle, below which arcs are lines

        /// Of length 1; none at all where it has none, as of messages that nobody filled.
        public Quaternion unit() {
            double length = Math.sqrt(x * x + y * y + z * z + w * w);
            return length == 0
                    ? new Quaternion(0, 0, 0, 1)
                    : new Quaternion(x / length, y / length, z / length, w / length);
        }

        /// The rotation back.
        public Quaternion conjugate() {
            return new Quaternion(-x, -y, -z, w);
        }

        /// First the other one, then this.
        public Quaternion times(Quaternion other) {
            return new Quaternion(
                    w * other.x + x * other.w + y * other.z - z * other.y,
                    w * other.y - x * other.z + y * other.w + z * other.x,
                    w * other.z + x * other.y - y * other.x + z * other.w,
                    w * other.w - x * other.x - y * other.y - z * other.z);
        }

        /// Between this one and another, both of length 1, on the shortest way at an even speed (slerp): K. Shoemake,
        /// Animating Rotation with Quaternion Curves, SIGGRAPH 1985.
        ///
        /// @param share of the way to the other one, 0 to 1
        public Quaternion interpolated(Quaternion other, double share) {
            double cosine = x * other.x + y * other.y + z * other.z + w * other.w;
            double angle = Math.acos(Math.min(1, Math.abs(cosine)));
            double sine = Math.sin(angle);
            double here = sine < NEARLY_EQUAL ? 1 - share : Math.sin((1 - share) * angle) / sine;
            double there = sine < NEARLY_EQUAL ? share : Math.sin(share * angle) / sine;
            double signed = cosine < 0 ? -there : there; // q and -q are the same rotation
            return new Quaternion(
                            here * x + signed * other.x,
                            here * y + signed * other.y,
                            here * z + signed * other.z,
                            here * w + signed * other.w)
                    .unit();
        }

        /// A vector after it: x, y, z.
        public double[] rotated(double vx, double vy, double vz) {
            Quaternion turned = times(new Quaternion(vx, vy, vz, 0)).times(conjugate());
            return new double[] {turned.x, turned.y, turned.z};
        }
    }
}
