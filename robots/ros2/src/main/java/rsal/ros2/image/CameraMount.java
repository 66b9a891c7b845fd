package rsal.ros2.image;

import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.ros2.message.FrameTransform;

/// Where a camera is on its robot, whose messages are in its optical frame (z ahead, x to the right) or in one with x
/// ahead (REP 103).
///
/// @param baseFromFrame of its messages
public record CameraMount(FrameTransform baseFromFrame) {
    private static final double LEVEL = 0.7; // of the z axis, upwards: less than 45° above the floor

    private boolean isOptical() {
        return Math.abs(baseFromFrame.rotation().rotated(0, 0, 1)[2]) < LEVEL;
    }

    /// Seen from above, looking along the x axis.
    public Pose2d baseFromCamera() {
        if (!isOptical()) {
            return baseFromFrame.planar();
        }
        double[] ahead = baseFromFrame.rotation().rotated(0, 0, 1);
        return new Pose2d(baseFromFrame.x(), baseFromFrame.y(), Math.atan2(ahead[1], ahead[0]));
    }

    /// Where something is, seen from above.
    ///
    /// @param x in the frame of its messages [m]
    /// @param y in the frame of its messages [m]
    /// @param z in the frame of its messages [m]
    public Point2d baseFromPoint(double x, double y, double z) {
        double[] moved = baseFromFrame.rotation().rotated(x, y, z);
        return new Point2d(baseFromFrame.x() + moved[0], baseFromFrame.y() + moved[1]);
    }

    /// A mount that only the model tells.
    ///
    /// @param frame of its messages, whose name tells whether it is optical
    public static CameraMount of(Pose2d baseFromCamera, String frame) {
        FrameTransform pose = FrameTransform.of(baseFromCamera);
        return new CameraMount(frame.endsWith("optical_frame") ? pose.compose(FrameTransform.OPTICAL) : pose);
    }
}
