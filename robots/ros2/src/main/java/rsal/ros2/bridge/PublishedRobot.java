package rsal.ros2.bridge;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Executor;
import rsal.data.OccupancyGrid;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.simulation.PublishedTime;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.CommandTimeout;
import rsal.system.CommandWatch;
import rsal.system.ExportedDevice;

/// A robot of ours as topics in its namespace, with frames as Nav2 wants them of several robots: without a prefix, on
/// topics `tf` and `tf_static` of their own. Takes velocities, poses and goals.
///
/// A velocity holds until another one comes, or none came for too long ([CommandTimeout]).
final class PublishedRobot {
    private static final Duration AGAIN = Duration.ofMillis(100);
    private static final String TWIST = "geometry_msgs/msg/Twist";
    private static final String STAMPED_TWIST = "geometry_msgs/msg/TwistStamped";
    private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";

    private static final String POSE = "geometry_msgs/msg/PoseWithCovarianceStamped";
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);

    private final Robot robot;
    private final RosLink link;
    private final PublishedTime scheduler;
    private final Executor requests; // are answered also while the run is paused
    private final List<NodeParameters.Parameter> parameters;
    private final int port;
    private final String namespace;
    private final List<ExportedDevice> offers = new ArrayList<>();
    private final List<Runnable> ends = new ArrayList<>();
    private final List<Runnable> aborts = new ArrayList<>(); // of goals
    private final CommandTimeout timeout;
    private final CommandWatch watch;
    private Optional<Twist2d> wanted = Optional.empty();

    /// @param worldMap what robots know of the world
    /// @param timeout of commands
    /// @param parameters of its nodes
    /// @param requests on whose thread they are answered
    PublishedRobot(
            Robot robot,
            OccupancyGrid worldMap,
            CommandTimeout timeout,
            List<NodeParameters.Parameter> parameters,
            RosLink link,
            int port,
            Executor requests,
            PublishedTime scheduler) {
        this.robot = robot;
        this.link = link;
        this.scheduler = scheduler;
        this.port = port;
        namespace = RosNetwork.namespace(robot.id());
        this.requests = requests;
        this.parameters = parameters;
        this.timeout = timeout;
        watch = timeout.watch();
        Publication transforms = advertise("tf", TRANSFORMS, Profile.DEFAULT);
        Publication fixed = advertise("tf_static", TRANSFORMS, Profile.LATCHED);
        Publication map = advertise("map", "nav_msgs/msg/OccupancyGrid", Profile.LATCHED);
        map.publish(new RosMessages().map(scheduler.instant(), worldMap, FrameNames.PLAIN.map()));
        var outlet = new RobotOutlet(
                robot,
                link,
                namespace,
                FrameNames.PLAIN,
                new MountedFrames(fixed, transforms, scheduler),
                this::offer,
                new Subscribers(link, scheduler.inRealTime())::isHeard,
                scheduler);
        var sensors = new RobotPublications(outlet, transforms);
        ends.add(sensors::close);
        sensors.begin();
        robot.find(DriveBase.class).ifPresent(this::takeVelocities);
        var goals = new GoalServers.Context(
                outlet, worldMap, link, node -> new Services(node, TYPES, requests), this::active, scheduler);
        for (Device device : robot.devices()) {
            if (device instanceof Localizer localizer) {
                takePoses(localizer);
                ParticlePublication.begin(localizer, outlet);
            } else {
                GoalServers.serve(device, goals).forEach(this::add);
            }
            if (device instanceof Navigator navigator) {
                CostPublication.begin(navigator, outlet);
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

    private void takeVelocities(DriveBase base) {
        offer(base, "cmd_vel");
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
        bytes.text(FrameNames.PLAIN.base());
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

    private void takePoses(Localizer localizer) {
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
    }

    private void add(GoalServers.Served served) {
        offer(served.device(), served.name());
        aborts.add(served.abort());
        ends.add(served.close());
    }

    /// The simulation is stopped: nothing that was commanded holds any more.
    void halt() {
        aborts.forEach(Runnable::run);
        stop();
    }

    private void stop() {
        if (wanted.isPresent()) {
            wanted = Optional.empty();
            robot.find(DriveBase.class).ifPresent(base -> base.command(Twist2d.STOP));
        }
    }

    /// Whose state Nav2's programs ask for before they send goals.
    private ActiveNode active(String name) {
        return new ActiveNode(link, namespace, name, parameters, requests, scheduler);
    }

    List<ExportedDevice> offers() {
        return List.copyOf(offers);
    }

    /// A robot that was driven stops.
    void close() {
        ends.forEach(Runnable::run);
        stop();
    }
}
