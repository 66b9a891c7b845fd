package rsal.ros2.bag;

import java.util.HashMap;
import java.util.Map;
import java.util.Optional;

/// Frames that do not move on the robot (`/tf_static`): a tree. The newest transform of a frame counts.
final class StaticFrames {
    private static final int MOST_FRAMES = 10_000;
    private static final int MOST_LEVELS = 1_000; // so that a circle ends

    private final Map<String, Link> links = new HashMap<>(); // by child

    private record Link(String parent, FrameTransform parentFromChild) {}

    /// Where a frame is in the root of its tree.
    private record Rooted(String root, FrameTransform rootFromFrame) {}

    void add(String parent, String child, FrameTransform parentFromChild) {
        if (links.size() < MOST_FRAMES) {
            links.put(named(child), new Link(named(parent), parentFromChild));
        }
    }

    /// Where one frame is in another one; empty when they are not in the same tree.
    Optional<FrameTransform> find(String frame, String other) {
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
    static String named(String frame) {
        return frame.startsWith("/") ? frame.substring(1) : frame;
    }
}
