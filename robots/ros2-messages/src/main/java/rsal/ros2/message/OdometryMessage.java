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
    private static final int COVARIANCES = 36;

    /// @param likelyFrame what its frame probably is, so that no other text is made
    /// @param likelyChild the same of the robot
    public static OdometryMessage read(CdrReader bytes, String likelyFrame, String likelyChild) throws InvalidCdr {
        long stamp = RosMessages.stamp(bytes);
        String frame = bytes.text(likelyFrame);
        String child = bytes.text(likelyChild);
        double x = bytes.float64();
        double y = bytes.float64();
        double z = bytes.float64();
        var turned = new Quaternion(bytes.float64(), bytes.float64(), bytes.float64(), bytes.float64());
        bytes.skip(Double.BYTES, COVARIANCES);
        return new OdometryMessage(
                stamp, frame, child, new FrameTransform(x, y, z, turned.unit()).planar(), RosMessages.twist(bytes));
    }

    public boolean isFinite() {
        return odomFromBase.isFinite() && velocity.isFinite();
    }
}
