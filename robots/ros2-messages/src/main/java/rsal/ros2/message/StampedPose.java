package rsal.ros2.message;

import java.util.Optional;
import rsal.data.Pose2d;
import rsal.ros2.cdr.RosMessage;

/// Poses as `geometry_msgs/PoseStamped`.
public final class StampedPose {
    /// The frame of maps (REP 105).
    public static final String MAP = "map";

    private StampedPose() {}

    /// A pose on the map, in the plane; empty when it is not finite or in another frame. No frame means the map.
    public static Optional<Pose2d> onMap(RosMessage message) {
        String frame = RosMessages.frame(message.message("header").text("frame_id"));
        Pose2d pose = FrameTransform.of(message.message("pose"), "position", "orientation")
                .planar();
        return Optional.of(pose).filter(one -> one.isFinite() && (frame.isEmpty() || frame.equals(MAP)));
    }

    /// @param zero a message of the peer's distribution, whose other fields stay
    /// @param frame in which the pose is
    public static RosMessage of(RosMessage zero, String frame, Pose2d pose) {
        FrameTransform place = FrameTransform.of(pose);
        RosMessage at = zero.message("pose");
        RosMessage position = at.message("position").with("x", place.x()).with("y", place.y());
        RosMessage orientation = at.message("orientation")
                .with("z", place.rotation().z())
                .with("w", place.rotation().w());
        return zero.with("header", zero.message("header").with("frame_id", frame))
                .with("pose", at.with("position", position).with("orientation", orientation));
    }
}
