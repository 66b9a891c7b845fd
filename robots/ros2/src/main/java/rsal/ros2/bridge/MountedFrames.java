package rsal.ros2.bridge;

import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.Map;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;

/// Where sensors are on their robots (`tf_static`). All of them are told when one is new, as those who come late get
/// the last message only.
final class MountedFrames {
    private final RosMessages messages = new RosMessages();
    private final Publication publication;
    private final Map<String, Mount> mounts = new LinkedHashMap<>(); // by frame

    private record Mount(String base, FrameTransform baseFromFrame) {}

    MountedFrames(Publication publication) {
        this.publication = publication;
    }

    /// Notes where a sensor is.
    ///
    /// @return whether that is new, so that it is to be published
    boolean put(String base, String frame, FrameTransform baseFromFrame) {
        var mount = new Mount(base, baseFromFrame);
        return !mount.equals(mounts.put(frame, mount));
    }

    void publish(Instant time) {
        publication.publish(messages.transforms(mounts.entrySet().stream()
                .map(each -> new Transform(
                        time,
                        each.getValue().base(),
                        each.getKey(),
                        each.getValue().baseFromFrame()))
                .toList()));
    }
}
