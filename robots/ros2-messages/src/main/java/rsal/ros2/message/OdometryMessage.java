package rsal.ros2.message;

import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.message.FrameTransform.Quaternion;

/// What is said in a `nav_msgs/Odometry`, without its covariances.
///
/// @param stamp when it was measured [ns] since 1970, or of a simulated time
/// @param frame in which the pose is, mostly `odom`
/// @param childFrame the robot's, in which the velocity is
/// @param odomFromBase pose in the plane
/// @param velocity [m/s, rad/s]
public record OdometryMessage(long stamp, String frame, String childFrame, Pose2d odomFromBase, Twist2d velocity) {
    private static final long SECOND = 1_000_000_000; // ns
    private static final int COVARIANCES = 36;

    /// @param likelyFrame what its frame probably is, so that no other text is made
    /// @param likelyChild the same of the robot
    public static OdometryMessage read(CdrReader bytes, String likelyFrame, String likelyChild) throws InvalidCdr {
        long seconds = bytes.int32();
        long stamp = seconds * SECOND + Integer.toUnsignedLong(bytes.int32());
        String frame = bytes.text(likelyFrame);
        String child = bytes.text(likelyChild);
        double x = bytes.float64();
        double y = bytes.float64();
        double z = bytes.float64();
        var turned = new Quaternion(bytes.float64(), bytes.float64(), bytes.float64(), bytes.float64());
        bytes.skip(Double.BYTES, COVARIANCES);
        double vx = bytes.float64();
        double vy = bytes.float64();
        bytes.skip(Double.BYTES, 3); // upwards, and turning about the other axes
        double omega = bytes.float64();
        return new OdometryMessage(
                stamp, frame, child, new FrameTransform(x, y, z, turned.unit()).planar(), new Twist2d(vx, vy, omega));
    }

    public boolean isFinite() {
        return odomFromBase.isFinite() && velocity.isFinite();
    }
}
