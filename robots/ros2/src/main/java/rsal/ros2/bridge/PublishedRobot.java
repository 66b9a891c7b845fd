package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.Executor;
import rsal.data.LaserScan;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Battery;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Publication;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.BridgeContext;
import rsal.system.CommandTimeout;
import rsal.system.CommandWatch;
import rsal.system.ExportedDevice;
import rsal.time.Scheduler;

/// A robot of ours as topics in its namespace, with frames as Nav2 wants them of several robots: without a prefix, on
/// topics `tf` and `tf_static` of their own.
///
/// A velocity holds until another one comes, or none came for too long ([CommandTimeout]).
final class PublishedRobot {
    private static final Duration AGAIN = Duration.ofMillis(100);
    private static final String MAP = "map"; // frames of REP 105
    private static final String ODOM = "odom";
    private static final String BASE = "base_link";
    private static final String TWIST = "geometry_msgs/msg/Twist";
    private static final String STAMPED_TWIST = "geometry_msgs/msg/TwistStamped";
    private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";

    private static final String POSE = "geometry_msgs/msg/PoseWithCovarianceStamped";
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final Robot robot;
    private final RosLink link;
    private final Scheduler scheduler;
    private final Executor requests; // are answered also while the run is paused
    private final List<NodeParameters.Parameter> parameters;
    private final int port;
    private final String namespace;
    private final RosMessages messages = new RosMessages();
    private final List<ExportedDevice> offers = new ArrayList<>();
    private final List<Runnable> ends = new ArrayList<>();
    private final Map<String, Pose2d> mounted = new LinkedHashMap<>(); // where sensors are, by their frames
    private final Publication transforms;
    private final Publication fixed;
    private final CommandTimeout timeout;
    private final CommandWatch watch;
    private Optional<Twist2d> wanted = Optional.empty();
    private Optional<Pose2d> odomFromBase = Optional.empty();

    /// @param parameters of its nodes
    /// @param requests on whose thread they are answered
    PublishedRobot(
            Robot robot,
            BridgeContext context,
            List<NodeParameters.Parameter> parameters,
            RosLink link,
            int port,
            Executor requests,
            Scheduler scheduler) {
        this.robot = robot;
        this.link = link;
        this.scheduler = scheduler;
        this.port = port;
        namespace = RosNetwork.namespace(robot.id());
        this.requests = requests;
        this.parameters = parameters;
        timeout = context.timeout();
        watch = timeout.watch();
        transforms = advertise("tf", TRANSFORMS, Profile.DEFAULT);
        fixed = advertise("tf_static", TRANSFORMS, Profile.LATCHED);
        Publication map = advertise("map", "nav_msgs/msg/OccupancyGrid", Profile.LATCHED);
        map.publish(messages.map(scheduler.instant(), context.map(), MAP));
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
                case Navigator navigator -> publish(navigator);
                default -> {}
            }
        }
    }

    private Publication advertise(String name, String type, Profile profile) {
        Publication publication = link.advertise(new RosTopic(namespace + "/" + name, type), profile);
        ends.add(publication::close);
        return publication;
    }

    private void offer(Device device, String topic) {
        offers.add(
                new ExportedDevice(port, namespace + "/" + topic, device.info().id()));
    }

    private void publish(DriveBase base) {
        Publication odometry = advertise("odom", "nav_msgs/msg/Odometry", Profile.DEFAULT);
        offer(base, "odom");
        offer(base, "cmd_vel");
        ends.add(base.subscribe(reading -> tellOdometry(odometry, reading))::cancel);
        Subscribed commands = listen(TWIST, RosMessages::twist, base);
        Subscribed stamped = listen(STAMPED_TWIST, PublishedRobot::stampedTwist, base);
        ends.add(scheduler.every(AGAIN, () -> drive(base, commands.publishers() + stamped.publishers()))::cancel);
    }

    private Subscribed listen(String type, Inbox.Decoder<Twist2d> decoder, DriveBase base) {
        var inbox = new Inbox<>(1, decoder, scheduler, velocity -> obey(base, velocity));
        Subscribed commands = link.subscribe(new RosTopic(namespace + "/cmd_vel", type), Profile.SENSOR_DATA, inbox);
        ends.add(commands::close);
        return commands;
    }

    private static Twist2d stampedTwist(CdrReader bytes) throws InvalidCdr {
        bytes.skip(Integer.BYTES, 2); // its time
        bytes.text(BASE);
        return RosMessages.twist(bytes);
    }

    private void obey(DriveBase base, Twist2d velocity) {
        if (velocity.isFinite()) {
            watch.heard(timeout.now());
            wanted = Optional.of(velocity);
            base.command(velocity);
        }
    }

    /// Bases of ours stop when no command comes, so the newest one is repeated, as long as somebody is there who gives
    /// them.
    private void drive(DriveBase base, int publishers) {
        if (wanted.isPresent() && (publishers == 0 || watch.isSilent(timeout.now(), AGAIN))) {
            wanted = Optional.empty();
            base.command(Twist2d.STOP);
        }
        wanted.ifPresent(base::command);
    }

    private void tellOdometry(Publication odometry, Stamped<Odometry> reading) {
        Pose2d pose = reading.value().odomFromBase();
        odomFromBase = Optional.of(pose);
        odometry.publish(messages.odometry(reading.time(), reading.value(), ODOM, BASE));
        transform(reading.time(), ODOM, BASE, pose);
    }

    private void transform(Instant time, String parent, String child, Pose2d pose) {
        transforms.publish(messages.transforms(List.of(new Transform(time, parent, child, FrameTransform.of(pose)))));
    }

    private void publish(LaserScanner laser, String name) {
        Publication scans = advertise(name, "sensor_msgs/msg/LaserScan", Profile.DEFAULT);
        offer(laser, name);
        ends.add(laser.subscribe(reading -> tellScan(scans, laser.info().name(), reading))::cancel);
    }

    private void tellScan(Publication scans, String frame, Stamped<LaserScan> reading) {
        if (mount(frame, reading.value().baseFromLaser())) {
            publishMountings(reading.time());
        }
        double period = 0; // which no device tells
        scans.publish(messages.scan(reading.time(), reading.value(), frame, period));
    }

    private void publish(SonarArray sonars) {
        var publications = new ArrayList<Publication>(); // one for each, once it is known how many there are
        ends.add(sonars.subscribe(reading -> {
            RangeArray ranges = reading.value();
            boolean isNew = false;
            for (int i = 0; i < ranges.count(); i++) {
                String name = "%s_%d".formatted(sonars.info().name(), i);
                if (i == publications.size()) {
                    publications.add(advertise(name, "sensor_msgs/msg/Range", Profile.DEFAULT));
                    offer(sonars, name);
                }
                isNew |= mount(name, ranges.baseFromSensors().get(i));
                publications.get(i).publish(messages.range(reading.time(), ranges, i, name));
            }
            if (isNew) {
                publishMountings(reading.time());
            }
        })::cancel);
    }

    /// Notes where a sensor is.
    ///
    /// @return whether that is new
    private boolean mount(String frame, Pose2d baseFromFrame) {
        return !baseFromFrame.equals(mounted.put(frame, baseFromFrame));
    }

    /// All of them, as those who come late get the last message only.
    private void publishMountings(Instant time) {
        fixed.publish(messages.transforms(mounted.entrySet().stream()
                .map(each -> new Transform(
                        time, BASE, each.getKey(), UrdfWriter.mounting(robot.model(), each.getKey(), each.getValue())))
                .toList()));
    }

    private void publish(Battery battery) {
        Publication states = advertise("battery_state", "sensor_msgs/msg/BatteryState", Profile.DEFAULT);
        offer(battery, "battery_state");
        ends.add(
                battery.subscribe(reading -> states.publish(messages.battery(reading.time(), reading.value(), BASE)))
                        ::cancel);
    }

    private void publish(Localizer localizer) {
        Publication poses = advertise("amcl_pose", POSE, Profile.LATCHED);
        offer(localizer, "amcl_pose");
        offer(localizer, "initialpose");
        ends.add(active("amcl")::close);
        MessageCodec codec = MessageCodec.of(TYPES.get(POSE), TYPES);
        ends.add(link.subscribe(
                new RosTopic(namespace + "/initialpose", POSE),
                Profile.DEFAULT,
                new Inbox<>(
                        1,
                        codec::read,
                        scheduler,
                        message -> RosMessages.estimate(message).ifPresent(localizer::relocalize)))::close);
        ends.add(localizer.subscribe(reading -> tellPose(poses, reading))::cancel);
    }

    private void publish(Navigator navigator) {
        String name = namespace + "/navigate_to_pose";
        offer(navigator, "navigate_to_pose");
        ActiveNode node = active("bt_navigator");
        ends.add(new PublishedNavigator(
                navigator, node.link(), new Services(node.link(), TYPES, requests), name, scheduler)::close);
        ends.add(node::close);
    }

    /// Whose state Nav2's programs ask for before they send goals.
    private ActiveNode active(String name) {
        return new ActiveNode(link, namespace, name, parameters, requests, scheduler);
    }

    private void tellPose(Publication poses, Stamped<PoseEstimate> reading) {
        poses.publish(messages.pose(reading.time(), reading.value(), MAP));
        odomFromBase.ifPresent(pose -> transform(
                reading.time(), MAP, ODOM, reading.value().mapFromBase().compose(pose.inverse())));
    }

    List<ExportedDevice> offers() {
        return List.copyOf(offers);
    }

    /// A robot that was driven stops.
    void close() {
        ends.forEach(Runnable::run);
        if (wanted.isPresent()) {
            robot.find(DriveBase.class).ifPresent(base -> base.command(Twist2d.STOP));
        }
    }
}
