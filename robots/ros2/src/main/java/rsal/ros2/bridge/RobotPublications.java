package rsal.ros2.bridge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.Battery;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;

/// What a robot of ours senses, as topics in its namespace; on a network and in recordings alike.
final class RobotPublications {
    private final Robot robot;
    private final RosPublisher link;
    private final String namespace;
    private final FrameNames frames;
    private final Publication transforms;
    private final MountedFrames mounted;
    private final BiConsumer<Device, String> published;
    private final RosMessages messages = new RosMessages();
    private final List<Runnable> ends = new ArrayList<>();
    private Optional<Pose2d> odomFromBase = Optional.empty();

    /// @param transforms where its frames are told that move
    /// @param mounted where its frames are told that don't
    /// @param published is told the name of each topic, without the namespace
    RobotPublications(
            Robot robot,
            RosPublisher link,
            String namespace,
            FrameNames frames,
            Publication transforms,
            MountedFrames mounted,
            BiConsumer<Device, String> published) {
        this.robot = robot;
        this.link = link;
        this.namespace = namespace;
        this.frames = frames;
        this.transforms = transforms;
        this.mounted = mounted;
        this.published = published;
    }

    /// Begins with all of its devices.
    void begin() {
        robot.find(DriveBase.class).ifPresent(this::publish);
        boolean isFirst = true;
        for (Device device : robot.devices()) {
            switch (device) {
                case LaserScanner laser -> {
                    publish(laser, isFirst ? "scan" : device.info().name());
                    isFirst = false;
                }
                case SonarArray sonars -> publish(sonars);
                case Battery battery -> publish(battery);
                case Localizer localizer -> publish(localizer);
                default -> {}
            }
        }
    }

    private Publication advertise(Device device, String name, String type, Profile profile) {
        Publication publication = link.advertise(new RosTopic(namespace + "/" + name, type), profile);
        ends.add(publication::close);
        published.accept(device, name);
        return publication;
    }

    private void publish(DriveBase base) {
        Publication odometry = advertise(base, "odom", "nav_msgs/msg/Odometry", Profile.DEFAULT);
        ends.add(base.subscribe(reading -> tellOdometry(odometry, reading))::cancel);
    }

    private void tellOdometry(Publication odometry, Stamped<Odometry> reading) {
        Pose2d pose = reading.value().odomFromBase();
        odomFromBase = Optional.of(pose);
        odometry.publish(messages.odometry(reading.time(), reading.value(), frames.odom(), frames.base()));
        transform(reading.time(), frames.odom(), frames.base(), pose);
    }

    private void transform(Instant time, String parent, String child, Pose2d pose) {
        transforms.publish(messages.transforms(List.of(new Transform(time, parent, child, FrameTransform.of(pose)))));
    }

    private void publish(LaserScanner laser, String name) {
        Publication scans = advertise(laser, name, "sensor_msgs/msg/LaserScan", Profile.DEFAULT);
        ends.add(laser.subscribe(reading -> tellScan(scans, laser.info().name(), reading))::cancel);
    }

    /// Notes where a sensor is.
    ///
    /// @param name the device's; of sonars with a number
    /// @return whether that is new, so that it is to be published
    private boolean mount(String name, Pose2d baseFromSensor) {
        return mounted.put(
                frames.base(), frames.sensor(name), UrdfWriter.mounting(robot.model(), name, baseFromSensor));
    }

    private void tellScan(Publication scans, String name, Stamped<LaserScan> reading) {
        if (mount(name, reading.value().baseFromLaser())) {
            mounted.publish(reading.time());
        }
        double period = 0; // which no device tells
        scans.publish(messages.scan(reading.time(), reading.value(), frames.sensor(name), period));
    }

    private void publish(SonarArray sonars) {
        var publications = new ArrayList<Publication>(); // one for each, once it is known how many there are
        ends.add(sonars.subscribe(reading -> {
            RangeArray ranges = reading.value();
            boolean isNew = false;
            for (int i = 0; i < ranges.count(); i++) {
                String name = "%s_%d".formatted(sonars.info().name(), i);
                if (i == publications.size()) {
                    publications.add(advertise(sonars, name, "sensor_msgs/msg/Range", Profile.DEFAULT));
                }
                isNew |= mount(name, ranges.baseFromSensors().get(i));
                publications.get(i).publish(messages.range(reading.time(), ranges, i, frames.sensor(name)));
            }
            if (isNew) {
                mounted.publish(reading.time());
            }
        })::cancel);
    }

    private void publish(Battery battery) {
        Publication states = advertise(battery, "battery_state", "sensor_msgs/msg/BatteryState", Profile.DEFAULT);
        ends.add(battery.subscribe(
                reading -> states.publish(messages.battery(reading.time(), reading.value(), frames.base())))::cancel);
    }

    private void publish(Localizer localizer) {
        Publication poses =
                advertise(localizer, "amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped", Profile.LATCHED);
        ends.add(localizer.subscribe(reading -> tellPose(poses, reading))::cancel);
    }

    private void tellPose(Publication poses, Stamped<PoseEstimate> reading) {
        poses.publish(messages.pose(reading.time(), reading.value(), frames.map()));
        odomFromBase.ifPresent(pose -> transform(
                reading.time(),
                frames.map(),
                frames.odom(),
                reading.value().mapFromBase().compose(pose.inverse())));
    }

    void close() {
        ends.forEach(Runnable::run);
    }
}
