package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.random.RandomGenerator;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.ros2.health.ReportNames;
import rsal.ros2.health.ReportedHealth;
import rsal.ros2.health.RobotDiagnostics;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.OdometryMessage;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.ros2.transform.TransformFeed;
import rsal.ros2.transform.TransformTopics;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// A robot whose devices are topics: for each part of its model the one that fits.
public final class RosRobot {
    /// How often it is to be looked after.
    public static final Duration LOOK = Duration.ofMillis(50);

    private static final String DRIVER = "ros2";
    private static final String ODOMETRY = "nav_msgs/msg/Odometry";
    private static final List<String> COMMANDS = List.of("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped");
    private static final ReportNames BASE = ReportNames.of("odometry", "odom", "motor", "motors", "wheel", "wheels");

    private final RobotSpec spec;
    private final Scheduler scheduler;
    private final TransformFeed transforms;
    private final Frames frames;
    private final RobotClock clock;
    private final RosBase base;
    private final MotorSwitch motors;
    private final Subscribed driven;
    private final ReportedHealth reported;
    private final List<Device> devices = new ArrayList<>();
    private final List<RosDevice> parts = new ArrayList<>(); // all but its base
    private final List<String> without = new ArrayList<>();
    private final List<Runnable> ends = new ArrayList<>(); // close what is no part's

    /// What a robot lacks without which it can't be used, for people; empty when all is there.
    ///
    /// @param topics of its namespace
    public static List<String> lacking(RobotTopics topics) {
        var lacking = new ArrayList<String>();
        if (topics.published(ODOMETRY, "odom").isEmpty()) {
            lacking.add("odometry (%s)".formatted(ODOMETRY));
        }
        if (topics.subscribed("cmd_vel", COMMANDS).isEmpty()) {
            lacking.add("a subscriber of 'cmd_vel' (%s)".formatted(String.join(" or ", COMMANDS)));
        }
        return lacking;
    }

    /// Whether it publishes all that the sensors of its model can have, such as depth of a camera.
    public static boolean isComplete(RobotSpec spec, RobotTopics topics, RosSettings settings) {
        return RosParts.wanted(spec.model()).stream().allMatch(wanted -> wanted.isComplete(topics, settings));
    }

    /// Whether a part can be made of topics.
    public static boolean has(Part part) {
        return RosParts.maker(part).isPresent();
    }

    /// @param topics that have all that it needs: nothing is [#lacking]
    /// @param shared where frames are, for all robots of the link
    /// @param diagnostics empty where they do not matter
    /// @param random for ids of goals, which nobody else may have
    public RosRobot(
            RobotSpec spec,
            RobotTopics topics,
            RosLink link,
            TransformTopics shared,
            TypeLibrary types,
            RosSettings settings,
            Optional<RobotDiagnostics> diagnostics,
            Scheduler scheduler,
            RandomGenerator random) {
        Safety safety = settings.safety();
        this.spec = spec;
        this.scheduler = scheduler;
        transforms = shared.feed(transformTopic(topics, "tf"), transformTopic(topics, "tf_static"), types);
        frames = new Frames(transforms, scheduler);
        clock = new RobotClock(scheduler, settings.useSimTime());
        RosTopic commands = topics.subscribed("cmd_vel", COMMANDS).orElseThrow();
        RosTopic odometry = topics.published(ODOMETRY, "odom").getFirst();
        var publication = link.advertise(commands, Profile.DEFAULT);
        ends.add(publication::close);
        base = new RosBase(
                new DeviceInfo(spec.id(), "base", DRIVER),
                odometry.name(),
                publication,
                commands.type().equals(COMMANDS.getLast()),
                spec.model().drive(),
                safety,
                frames,
                clock);
        var context = new RosContext(topics, link, types, scheduler, frames, clock, base, settings, random);
        motors = new MotorSwitch(spec.id(), link, topics.namespace(), safety);
        base.onMotors(motors::publish);
        ends.add(motors::close);
        reported = new ReportedHealth(
                topics.namespace(), link, scheduler, diagnostics.map(all -> all.robot(topics.namespace())));
        reported.add(base, BASE);
        ends.add(reported::close);
        driven = link.subscribe(odometry, Profile.SENSOR_DATA, odometryInbox());
        devices.add(base);
        for (RosParts.Wanted wanted : RosParts.wanted(spec.model())) {
            if (wanted.isThere(topics, settings)) {
                var info = new DeviceInfo(spec.id(), wanted.name(), DRIVER);
                RosDevice made = wanted.maker().make(info, wanted, context);
                parts.add(made);
                devices.add(made.device());
                reported.add(made.device(), wanted.maker().reportNames());
            } else {
                without.add(wanted.name());
            }
        }
    }

    /// The robot's own where somebody publishes it, that of all robots otherwise.
    private static String transformTopic(RobotTopics topics, String name) {
        return topics.ownOrShared(name, TransformTopics.TYPE).name();
    }

    private Inbox<OdometryMessage> odometryInbox() {
        return new Inbox<>(
                1, bytes -> OdometryMessage.read(bytes, frames.odom(), frames.base()), scheduler, this::take);
    }

    private void take(OdometryMessage message) {
        if (message.isFinite()) {
            frames.learn(message);
            if (clock.learn(message.stamp())) {
                transforms.clear(List.of(frames.odom(), frames.base()));
            }
            base.take(message);
        }
    }

    /// Sensors of its model that it does not publish, by name: it is used without them.
    public List<String> without() {
        return List.copyOf(without);
    }

    /// It is part of the run from now on, or again. Its emergency stop, if it has one, gets the state of its motors.
    public void join() {
        motors.publish(base.enabled());
    }

    /// Whether it has told where it is by its wheels, so that agents can begin.
    public boolean isReady() {
        return base.hasReported();
    }

    public Robot robot() {
        return new Robot(spec.id(), spec.role(), spec.model(), spec.marker(), devices);
    }

    /// Whether it is there: somebody publishes its odometry.
    public boolean isThere() {
        return driven.publishers() > 0;
    }

    /// It is there again, and was not for a while. It stops, unless it is driven.
    public void appear() {
        base.appear();
    }

    /// Keeps it where it is while the run's time stands: nobody who could stop it does anything then.
    ///
    /// @param now in real time
    public void hold(Instant now) {
        base.hold(now);
    }

    /// The run's time goes on: it does what is wanted at once if it was held before.
    public void release(Instant now) {
        base.release(now);
    }

    /// Drives on, and looks how its devices are.
    public void look(Instant now) {
        base.drive(now);
        parts.forEach(made -> made.look().accept(now));
        base.look(now, driven.publishers());
        reported.look(now);
    }

    /// Stops it, for good.
    public void end() {
        parts.forEach(made -> made.close().run());
        base.end();
        driven.close();
        ends.forEach(Runnable::run);
    }
}
