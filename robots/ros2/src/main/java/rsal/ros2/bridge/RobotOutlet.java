package rsal.ros2.bridge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import java.util.function.BiConsumer;
import java.util.function.Predicate;
import rsal.data.Pose2d;
import rsal.device.Device;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.simulation.PublishedTime;
import rsal.ros2.urdf.UrdfWriter;

/// Where a robot's readings are published: its namespace on a network, or in a recording.
final class RobotOutlet {
    private final Robot robot;
    private final RosPublisher link;
    private final String namespace;
    private final FrameNames frames;
    private final MountedFrames mounted;
    private final BiConsumer<Device, String> published;
    private final Predicate<RosTopic> heard;
    private final PublishedTime time;
    private final List<Runnable> ends = new ArrayList<>();
    private final Set<String> mounts = new HashSet<>(); // frames of its sensors

    /// @param mounted where its sensors' frames are published
    /// @param published gets the name of each topic, without the namespace
    /// @param heard whether somebody wants the messages of a topic
    /// @param time that messages have
    RobotOutlet(
            Robot robot,
            RosPublisher link,
            String namespace,
            FrameNames frames,
            MountedFrames mounted,
            BiConsumer<Device, String> published,
            Predicate<RosTopic> heard,
            PublishedTime time) {
        this.robot = robot;
        this.link = link;
        this.namespace = namespace;
        this.frames = frames;
        this.mounted = mounted;
        this.published = published;
        this.heard = heard;
        this.time = time;
    }

    Robot robot() {
        return robot;
    }

    /// The time that messages have of what was at a time of the run.
    Instant stamp(Instant ofRun) {
        return time.stamp(ofRun);
    }

    FrameNames frames() {
        return frames;
    }

    /// @param name in the robot's namespace
    Publication advertise(Device device, String name, String type, Profile profile) {
        Publication publication = link.advertise(topic(name, type), profile);
        ends.add(publication::close);
        published.accept(device, name);
        return publication;
    }

    /// @param name in the robot's namespace
    RosTopic topic(String name, String type) {
        return new RosTopic(namespace + "/" + name, type);
    }

    boolean isHeard(RosTopic topic) {
        return heard.test(topic);
    }

    /// The usual name for the first device of a kind, the device's own name for others.
    String name(Device device, Class<? extends Device> kind, String usual) {
        boolean isFirst = robot.devices().stream()
                .filter(kind::isInstance)
                .findFirst()
                .filter(device::equals)
                .isPresent();
        return isFirst ? usual : device.info().name();
    }

    /// Notes where a sensor is.
    ///
    /// @param name the device's; of sonars with a number
    /// @return whether that is new, so that mounts are to be published
    boolean mount(Instant time, String name, Pose2d baseFromSensor) {
        return mount(
                time, frames.base(), frames.sensor(name), UrdfWriter.mounting(robot.model(), name, baseFromSensor));
    }

    private boolean mount(Instant time, String base, String frame, FrameTransform baseFromFrame) {
        mounts.add(frame);
        return mounted.put(time, base, frame, baseFromFrame);
    }

    /// Notes where a camera is, which looks along its x axis, with its optical frame.
    ///
    /// @return whether that is new, so that mounts are to be published
    boolean mountCamera(Instant time, String name, Pose2d baseFromCamera) {
        boolean isNew = mount(time, name, baseFromCamera);
        return mount(time, frames.sensor(name), frames.optical(name), FrameTransform.OPTICAL) || isNew;
    }

    void publishMounts(Instant time) {
        mounted.publish(time);
    }

    /// Until it is closed.
    void keep(Subscription subscription) {
        ends.add(subscription::cancel);
    }

    void close() {
        ends.forEach(Runnable::run);
        mounted.remove(mounts);
    }
}
