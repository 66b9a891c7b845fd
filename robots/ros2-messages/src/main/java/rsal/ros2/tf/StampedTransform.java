package rsal.ros2.tf;

import java.util.ArrayList;
import java.util.List;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;

/// Where a frame is in its parent at a time (`geometry_msgs/TransformStamped`).
///
/// @param stamp [ns] since 1970, or of a simulated time
public record StampedTransform(long stamp, String parent, String child, FrameTransform parentFromChild) {
    /// Names without the slash with which old ones begin.
    public StampedTransform {
        parent = RosMessages.frame(parent);
        child = RosMessages.frame(child);
    }

    /// Those of a `tf2_msgs/TFMessage`. What has values that are no numbers is left out.
    public static List<StampedTransform> of(RosMessage transforms) {
        var all = new ArrayList<StampedTransform>();
        for (RosMessage stamped : transforms.messages("transforms")) {
            FrameTransform transform = FrameTransform.of(stamped.message("transform"), "translation", "rotation");
            RosMessage header = stamped.message("header");
            if (transform.isFinite()) {
                all.add(new StampedTransform(
                        RosMessages.stamp(header), header.text("frame_id"), stamped.text("child_frame_id"), transform));
            }
        }
        return all;
    }
}
