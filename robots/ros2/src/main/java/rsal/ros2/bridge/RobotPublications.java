package rsal.ros2.bridge;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
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
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;

/// What a robot of ours senses, as topics in its namespace; on a network and in recordings alike.
final class RobotPublications {
    private final Robot robot;
    private final RobotOutlet outlet;
    private final FrameNames frames;
    private final Publication transforms;
    private final RosMessages messages;
    private Optional<Pose2d> odomFromBase = Optional.empty();

    /// @param outlet which this closes
    /// @param transforms where its frames are told that move
    RobotPublications(RobotOutlet outlet, Publication transforms) {
        this.outlet = outlet;
        this.robot = outlet.robot();
        this.messages = new RosMessages(outlet::stamp);
        this.frames = outlet.frames();
        this.transforms = transforms;
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
                default -> SensorPublications.begin(device, outlet);
            }
        }
    }

    private void publish(DriveBase base) {
        Publication odometry = outlet.advertise(base, "odom", "nav_msgs/msg/Odometry", Profile.DEFAULT);
        outlet.keep(base.subscribe(reading -> publishOdometry(odometry, reading)));
    }

    private void publishOdometry(Publication odometry, Stamped<Odometry> reading) {
        Pose2d pose = reading.value().odomFromBase();
        odomFromBase = Optional.of(pose);
        odometry.publish(messages.odometry(reading.time(), reading.value(), frames.odom(), frames.base()));
        transform(reading.time(), frames.odom(), frames.base(), pose);
    }

    private void transform(Instant time, String parent, String child, Pose2d pose) {
        transforms.publish(messages.transforms(List.of(new Transform(time, parent, child, FrameTransform.of(pose)))));
    }

    private void publish(LaserScanner laser, String name) {
        Publication scans = outlet.advertise(laser, name, "sensor_msgs/msg/LaserScan", Profile.DEFAULT);
        outlet.keep(laser.subscribe(reading -> publishScan(scans, laser.info().name(), reading)));
    }

    private void publishScan(Publication scans, String name, Stamped<LaserScan> reading) {
        if (outlet.mount(reading.time(), name, reading.value().baseFromLaser())) {
            outlet.publishMounts(reading.time());
        }
        double period = 0; // which no device tells
        scans.publish(messages.scan(reading.time(), reading.value(), frames.sensor(name), period));
    }

    private void publish(SonarArray sonars) {
        var publications = new ArrayList<Publication>(); // one for each, once it is known how many there are
        outlet.keep(sonars.subscribe(reading -> {
            RangeArray ranges = reading.value();
            boolean isNew = false;
            for (int i = 0; i < ranges.count(); i++) {
                String name = "%s_%d".formatted(sonars.info().name(), i);
                if (i == publications.size()) {
                    publications.add(outlet.advertise(sonars, name, "sensor_msgs/msg/Range", Profile.DEFAULT));
                }
                isNew |= outlet.mount(
                        reading.time(), name, ranges.baseFromSensors().get(i));
                publications.get(i).publish(messages.range(reading.time(), ranges, i, frames.sensor(name)));
            }
            if (isNew) {
                outlet.publishMounts(reading.time());
            }
        }));
    }

    private void publish(Battery battery) {
        Publication states =
                outlet.advertise(battery, "battery_state", "sensor_msgs/msg/BatteryState", Profile.DEFAULT);
        outlet.keep(battery.subscribe(
                reading -> states.publish(messages.battery(reading.time(), reading.value(), frames.base()))));
    }

    private void publish(Localizer localizer) {
        Publication poses = outlet.advertise(
                localizer, "amcl_pose", "geometry_msgs/msg/PoseWithCovarianceStamped", Profile.LATCHED);
        outlet.keep(localizer.subscribe(reading -> publishPose(poses, reading)));
    }

    private void publishPose(Publication poses, Stamped<PoseEstimate> reading) {
        poses.publish(messages.pose(reading.time(), reading.value(), frames.map()));
        odomFromBase.ifPresent(pose -> transform(
                reading.time(),
                frames.map(),
                frames.odom(),
                reading.value().mapFromBase().compose(pose.inverse())));
    }

    void close() {
        outlet.close();
    }
}
