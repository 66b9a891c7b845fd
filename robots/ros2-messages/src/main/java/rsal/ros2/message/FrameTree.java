package rsal.ros2.message;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import rsal.ros2.cdr.RosMessage;

/// Where frames are in others (`/tf`, `/tf_static`): a tree. The newest transform of a frame counts. Of one thread.
public final class FrameTree {
    private static final int MOST_FRAMES = 10_000;
    private static final int MOST_LEVELS = 1_000; // so that a circle ends

    private final Map<String, Link> links = new HashMap<>(); // by child

    private record Link(String parent, FrameTransform parentFromChild) {}

    /// Where a frame is in the root of its tree.
    private record Rooted(String root, FrameTransform rootFromFrame) {}

    /// Those of a `tf2_msgs/TFMessage`. What has no numbers is left out.
    public void add(RosMessage transforms) {
        for (RosMessage stamped : transforms.messages("transforms")) {
            FrameTransform transform = FrameTransform.of(stamped.message("transform"), "translation", "rotation");
            if (transform.isFinite()) {
                add(stamped.message("header").text("frame_id"), stamped.text("child_frame_id"), transform);
            }
        }
    }

    public void add(String parent, String child, FrameTransform parentFromChild) {
        if (links.size() < MOST_FRAMES || links.containsKey(named(child))) {
            links.put(named(child), new Link(named(parent), parentFromChild));
        }
    }

    /// Where one frame is in another one; empty when they are not in the same tree.
    public Optional<FrameTransform> find(String frame, String other) {
        Optional<Rooted> one = rooted(named(frame));
        Optional<Rooted> two = rooted(named(other));
        return one.flatMap(from -> two.filter(to -> to.root().equals(from.root()))
                .map(to -> from.rootFromFrame().inverse().compose(to.rootFromFrame())));
    }

    private Optional<Rooted> rooted(String frame) {
        String at = frame;
        FrameTransform atFromFrame = FrameTransform.NONE;
        for (int level = 0; level < MOST_LEVELS; level++) {
            Link link = links.get(at);
            if (link == null) {
                return Optional.of(new Rooted(at, atFromFrame));
            }
            atFromFrame = link.parentFromChild().compose(atFromFrame);
            at = link.parent();
        }
        return Optional.empty();
    }

    /// Old names of frames begin with a slash.
    public static String named(String frame) {
        return frame.startsWith("/") ? frame.substring(1) : frame;
    }
}
