package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import rsal.device.Device;
import rsal.device.DeviceInfo;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.OdometryMessage;
import rsal.ros2.message.ScanMessage;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// A robot whose devices are topics: for each part of its model the one that fits.
public final class RosRobot {
    /// How often it is to be looked after.
    public static final Duration LOOK = Duration.ofMillis(50);

    private static final String DRIVER = "ros2";
    private static final String ODOMETRY = "nav_msgs/msg/Odometry";
    private static final String SCAN = "sensor_msgs/msg/LaserScan";
    private static final String RANGE = "sensor_msgs/msg/Range";
    private static final String BATTERY = "sensor_msgs/msg/BatteryState";
    private static final String POSE = "geometry_msgs/msg/PoseWithCovarianceStamped";
    private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";
    private static final List<String> COMMANDS = List.of("geometry_msgs/msg/Twist", "geometry_msgs/msg/TwistStamped");
    private static final String NAVIGATE = "nav2_msgs/action/NavigateToPose";
    private static final String MAP = "nav_msgs/msg/OccupancyGrid";
    private static final Set<Class<? extends Device>> OWN = Set.of(Localizer.class, Navigator.class, Mapper.class);
    private static final int TRANSFORMS_WAITING = 100;

    private final RobotSpec spec;
    private final RobotTopics topics;
    private final RosLink link;
    private final Scheduler scheduler;
    private final Frames frames;
    private final RobotClock clock;
    private final RosBase base;
    private final RosContext context;
    private final Subscribed driven;
    private final Map<RosSensor<?>, Subscribed> sensors = new LinkedHashMap<>();
    private final List<Device> devices = new ArrayList<>();
    private final List<RosDevice> registered = new ArrayList<>();
    private final List<RosNavigator> navigators = new ArrayList<>(); // one at most
    private final List<Runnable> others = new ArrayList<>(); // close what is no sensor's
    private final List<Consumer<OdometryMessage>> drivenListeners = new ArrayList<>();

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

    /// Sensors of its model that it does not publish, by name: the robot is used without them.
    public static List<String> without(RobotSpec spec, RobotTopics topics, RosSettings settings) {
        var without = new ArrayList<String>();
        int lasers = 0;
        for (Map.Entry<String, Part> part : spec.model().sensors().entrySet()) {
            boolean isThere = switch (part.getValue()) {
                case Part.Laser _ -> topics.published(SCAN, "scan").size() > lasers++;
                case Part.Battery _ ->
                    !topics.published(BATTERY, "battery_state").isEmpty();
                case Part.Sonars sonars ->
                    topics.published(RANGE, "").size()
                            >= sonars.baseFromSensors().size();
                default ->
                    RosParts.maker(part.getValue())
                            .map(maker -> maker.isThere(part.getKey(), part.getValue(), topics, settings))
                            .orElse(true);
            };
            if (!isThere) {
                without.add(part.getKey());
            }
        }
        return without;
    }

    /// Whether it publishes all that the sensors of its model can have, such as depth of a camera.
    public static boolean isComplete(RobotSpec spec, RobotTopics topics, RosSettings settings) {
        return without(spec, topics, settings).isEmpty()
                && spec.model().sensors().entrySet().stream()
                        .allMatch(part -> RosParts.maker(part.getValue())
                                .map(maker -> maker.isComplete(part.getKey(), part.getValue(), topics, settings))
                                .orElse(true));
    }

    /// Whether a part can be made of topics.
    public static boolean has(Part part) {
        return switch (part) {
            case Part.Laser _, Part.Sonars _, Part.Battery _ -> true;
            case Part.Own own -> OWN.contains(own.makes());
            default -> RosParts.maker(part).isPresent();
        };
    }

    /// @param topics that have all that it needs: nothing is [#lacking]
    /// @param random for ids of goals, which nobody else may have
    public RosRobot(
            RobotSpec spec,
            RobotTopics topics,
            RosLink link,
            TypeLibrary types,
            RosSettings settings,
            Scheduler scheduler,
            RandomGenerator random) {
        Safety safety = settings.safety();
        this.spec = spec;
        this.topics = topics;
        this.link = link;
        this.scheduler = scheduler;
        frames = new Frames(scheduler);
        clock = new RobotClock(scheduler);
        RosTopic commands = topics.subscribed("cmd_vel", COMMANDS).orElseThrow();
        RosTopic odometry = topics.published(ODOMETRY, "odom").getFirst();
        var publication = link.advertise(commands, Profile.DEFAULT);
        others.add(publication::close);
        base = new RosBase(
                new DeviceInfo(spec.id(), "base", DRIVER),
                odometry.name(),
                publication,
                commands.type().equals(COMMANDS.getLast()),
                spec.model().drive(),
                safety,
                frames,
                clock);
        context = new RosContext(topics, link, types, scheduler, frames, clock, base, settings.gripper(), random);
        var motors = new MotorSwitch(spec.id(), link, topics.namespace(), safety);
        motors.tell(base.enabled());
        base.onMotors(motors::tell);
        others.add(motors::close);
        driven = link.subscribe(odometry, Profile.SENSOR_DATA, odometryInbox());
        add(base, driven);
        others.add(link.subscribe(
                topics.ownOrShared("tf", TRANSFORMS),
                Profile.DEFAULT,
                context.inbox(TRANSFORMS, TRANSFORMS_WAITING, frames::add))::close);
        others.add(link.subscribe(
                topics.ownOrShared("tf_static", TRANSFORMS),
                Profile.LATCHED,
                context.inbox(TRANSFORMS, TRANSFORMS_WAITING, frames::addFixed))::close);
        List<String> without = without(spec, topics, settings);
        int lasers = 0;
        for (Map.Entry<String, Part> part : spec.model().sensors().entrySet()) {
            if (without.contains(part.getKey())) {
                continue;
            }
            var info = new DeviceInfo(spec.id(), part.getKey(), DRIVER);
            switch (part.getValue()) {
                case Part.Laser laser -> addLaser(info, laser, lasers++);
                case Part.Sonars sonars -> addSonars(info, sonars);
                case Part.Battery _ -> addBattery(info);
                case Part.Own own when own.makes().equals(Navigator.class) -> addNavigator(info, random);
                case Part.Own own when own.makes().equals(Mapper.class) -> addMap(info);
                case Part.Own _ -> addLocalizer(info);
                default ->
                    add(RosParts.maker(part.getValue())
                            .orElseThrow(() ->
                                    new IllegalArgumentException("'%s' is refused before.".formatted(part.getKey())))
                            .make(info, part.getValue(), context));
            }
        }
    }

    private void add(RosSensor<?> device, Subscribed subscription) {
        sensors.put(device, subscription);
        devices.add(device);
    }

    private void add(RosDevice made) {
        registered.add(made);
        devices.add(made.device());
    }

    private Inbox<OdometryMessage> odometryInbox() {
        return new Inbox<>(
                1, bytes -> OdometryMessage.read(bytes, frames.odom(), frames.base()), scheduler, this::take);
    }

    private void take(OdometryMessage message) {
        if (message.isFinite()) {
            frames.add(message);
            clock.learn(message.stamp());
            base.take(message);
            drivenListeners.forEach(listener -> listener.accept(message));
        }
    }

    private void addLaser(DeviceInfo info, Part.Laser part, int number) {
        RosTopic topic = topics.published(SCAN, "scan").get(number);
        var laser = new RosLaser(info, topic.name(), part, frames, clock);
        String likely = topic.name().substring(1);
        add(
                laser,
                link.subscribe(
                        topic,
                        Profile.SENSOR_DATA,
                        new Inbox<>(1, bytes -> ScanMessage.read(bytes, likely), scheduler, laser::take)));
    }

    private void addSonars(DeviceInfo info, Part.Sonars part) {
        List<RosTopic> all = topics.published(RANGE, "");
        var sonars = new RosSonars(info, all.getFirst().name(), part, frames, clock);
        for (int i = 0; i < part.baseFromSensors().size(); i++) {
            int sensor = i;
            Subscribed subscription = link.subscribe(
                    all.get(i), Profile.SENSOR_DATA, context.inbox(RANGE, 1, message -> sonars.take(sensor, message)));
            if (i == 0) {
                add(sonars, subscription);
            } else {
                others.add(subscription::close);
            }
        }
    }

    private void addBattery(DeviceInfo info) {
        RosTopic topic = topics.published(BATTERY, "battery_state").getFirst();
        var battery = new RosBattery(info, topic.name(), frames, clock);
        add(battery, link.subscribe(topic, Profile.SENSOR_DATA, context.inbox(BATTERY, 1, battery::take)));
    }

    /// Its pose may come as a topic, or by TF alone.
    private void addLocalizer(DeviceInfo info) {
        RosTopic topic = topics.published(POSE, "amcl_pose").stream()
                .findFirst()
                .orElseGet(() -> new RosTopic(topics.namespace() + "/amcl_pose", POSE));
        var initial = link.advertise(new RosTopic(topics.namespace() + "/initialpose", POSE), Profile.DEFAULT);
        others.add(initial::close);
        var localizer = new RosLocalizer(info, topic.name(), initial, frames, clock);
        drivenListeners.add(localizer::take);
        add(localizer, link.subscribe(topic, topics.reliable(topic), context.inbox(POSE, 1, localizer::take)));
    }

    private void addMap(DeviceInfo info) {
        RosTopic topic = topics.ownOrShared("map", MAP);
        var map = new PublicMap(info, topic.name(), clock);
        add(map, link.subscribe(topic, topics.reliable(topic), context.inbox(MAP, 1, map::take)));
    }

    private void addNavigator(DeviceInfo info, RandomGenerator random) {
        String name = topics.namespace() + "/navigate_to_pose";
        var action = new ActionClient(link, context.types(), name, NAVIGATE, scheduler, random);
        var navigator = new RosNavigator(info, action, name, base, frames);
        navigators.add(navigator);
        devices.add(navigator);
    }

    /// Whether it has told where it is by its wheels, so that agents can begin.
    public boolean isReady() {
        return base.hasTold();
    }

    public Robot robot() {
        return new Robot(spec.id(), spec.role(), spec.model(), spec.marker(), devices);
    }

    /// Drives on, and looks how its devices are.
    ///
    /// @return whether it is there: somebody publishes its odometry
    public boolean look(Instant now) {
        base.drive(now);
        navigators.forEach(navigator -> navigator.look(now));
        registered.forEach(made -> made.look().accept(now));
        sensors.forEach((sensor, subscription) -> sensor.look(now, subscription.publishers()));
        return driven.publishers() > 0;
    }

    /// Stops it, for good.
    public void end() {
        navigators.forEach(RosNavigator::end);
        registered.forEach(made -> made.close().run());
        base.end();
        sensors.values().forEach(Subscribed::close);
        others.forEach(Runnable::run);
    }
}
