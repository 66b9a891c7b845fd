package rsal.ros2.bridge;

import java.time.Instant;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.simulation.PublishedTime;

/// Where sensors are on their robots (`tf_static`). All of them are published when one is new, as those who come late
/// get the last message only. Those that an actuator moves are published as transforms that move (`tf`).
final class MountedFrames {
    private final RosMessages messages;
    private final Publication fixed;
    private final Publication moving;
    private final Map<String, Mount> mounts = new LinkedHashMap<>(); // by frame
    private final Set<String> moved = new HashSet<>(); // frames, which are not among the mounts

    private record Mount(String base, FrameTransform baseFromFrame) {}

    /// @param fixed `tf_static`
    /// @param moving `tf`
    /// @param time that messages have
    MountedFrames(Publication fixed, Publication moving, PublishedTime time) {
        messages = new RosMessages(time::stamp);
        this.fixed = fixed;
        this.moving = moving;
    }

    /// Notes where a sensor is; publishes it at once if it has moved.
    ///
    /// @return whether those that don't move have changed, and are to be published
    boolean put(Instant time, String base, String frame, FrameTransform baseFromFrame) {
        boolean hasChanged = false;
        if (!moved.contains(frame)) {
            var mount = new Mount(base, baseFromFrame);
            Mount before = mounts.putIfAbsent(frame, mount);
            if (before == null || before.equals(mount)) {
                return before == null;
            }
            mounts.remove(frame);
            moved.add(frame);
            hasChanged = true;
        }
        moving.publish(messages.transforms(List.of(new Transform(time, base, frame, baseFromFrame))));
        return hasChanged;
    }

    /// Those of a robot that has left.
    void remove(Set<String> frames) {
        mounts.keySet().removeAll(frames);
        moved.removeAll(frames);
    }

    void publish(Instant time) {
        fixed.publish(messages.transforms(mounts.entrySet().stream()
                .map(each -> new Transform(
                        time,
                        each.getValue().base(),
                        each.getKey(),
                        each.getValue().baseFromFrame()))
                .toList()));
    }
}
