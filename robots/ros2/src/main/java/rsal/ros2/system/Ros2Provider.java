package rsal.ros2.system;

import java.net.InetAddress;
import java.net.URI;
import java.security.SecureRandom;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.ros2.device.RosRobot;
import rsal.ros2.link.RosEnvironment;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.rosbridge.RosbridgeAddress;
import rsal.ros2.rosbridge.RosbridgeLink;
import rsal.ros2.rosbridge.RosbridgeOptions;
import rsal.ros2.rosbridge.RosbridgeOptions.Encoding;
import rsal.ros2.rosbridge.WebSocketTransport;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.ros2.system.Ros2System.Opening;
import rsal.ros2.type.Distribution;
import rsal.rtps.UdpParticipant;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.system.RealRobots;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.system.RobotSystemProvider.InvalidRobots.Problem;
import rsal.time.Scheduler;

/// Robots of ROS 2, real ones or those of another simulator, by DDS or rosbridge. They have real time, or that of
/// their simulator.
public final class Ros2Provider implements RobotSystemProvider {
    private static final String NODE = "rsal";
    private static final Pattern NAMESPACE = Pattern.compile("/|(/[A-Za-z_][A-Za-z0-9_]*)+");
    private static final int FROM_ENVIRONMENT = -1;
    private static final String ANNOUNCED = "announced";
    private static final String CBOR = "cbor";

    private static final Parameter<String> NAMESPACES = Parameter.text(
            "namespaces",
            "",
            "Namespaces of the robots, in order, separated by commas: /robot1, /robot2; / for topics without a"
                    + " namespace. Default: their ids, with _ for -.");
    static final Parameter<Integer> DOMAIN = Parameter.integer(
            "domain",
            FROM_ENVIRONMENT,
            FROM_ENVIRONMENT,
            232,
            "",
            "The domain of ROS 2; -1 takes ROS_DOMAIN_ID of the environment, or 0.");
    static final Parameter<String> ADDRESS = Parameter.text(
            "address",
            "",
            "The address of this machine by which robots reach it; several, separated by commas, for several networks;"
                    + " 0.0.0.0 for all. Default: 127.0.0.1, which finds programs on this machine only, unless 'peers'"
                    + " or ROS_AUTOMATIC_DISCOVERY_RANGE say more.");
    static final Parameter<String> PEERS = Parameter.text(
            "peers",
            "",
            "Machines on which to search for robots if the network has no multicast, separated by commas. Those in"
                    + " ROS_STATIC_PEERS are added.");
    static final Parameter<String> ROSBRIDGE = Parameter.text(
            "rosbridge",
            "",
            "The address of a rosbridge server, such as ws://robot.local:9090, for ROS 1 and for networks that DDS does"
                    + " not cross. Default: robots are found by DDS.");
    private static final Parameter<String> ROSBRIDGE_ENCODING = Parameter.choice(
            "rosbridgeEncoding",
            CBOR,
            List.of(CBOR, "json"),
            "How a rosbridge server writes messages. cbor: binary where it can; json: for servers without CBOR.");
    private static final Parameter<Double> ROSBRIDGE_RATE = Parameter.number(
            "rosbridgeRate",
            0,
            0,
            1_000,
            "Hz",
            "How often a rosbridge server sends the readings of each sensor at most, for slow networks; 0: all of them.");
    private static final Parameter<String> DISTRIBUTION = Parameter.choice(
            "distribution",
            ANNOUNCED,
            Stream.concat(
                            Stream.of(ANNOUNCED),
                            Arrays.stream(Distribution.values()).map(Distribution::words))
                    .toList(),
            "The distribution of ROS 2 that the robots run. announced: the one that each robot announces.");

    private static final Parameter<Boolean> DIAGNOSTICS = Parameter.flag(
            "diagnostics",
            true,
            "Whether errors in the robots' diagnostics (diagnostic_msgs/DiagnosticArray) are errors of their devices.");
    private static final Parameter<String> STOP_TOPIC = Parameter.text(
            "stopTopic",
            "",
            "A topic in each robot's namespace, such as e_stop. It gets std_msgs/Bool: true while the robot's motors are"
                    + " off, as after an emergency stop. Default: none.");
    private static final Parameter<String> STOP_SERVICE = Parameter.text(
            "stopService",
            "",
            "A service of type std_srvs/SetBool in each robot's namespace. It is called with true when the robot's motors"
                    + " are switched off, and with false when they are switched on. Default: none.");

    static final Parameter<Boolean> USE_SIM_TIME = Parameter.flag(
            "useSimTime",
            false,
            "Whether the run follows the time of another simulator, which publishes it on /clock, as nodes with"
                    + " use_sim_time do.");

    private static final Parameter<String> GRIPPER_ACTION = Parameter.text(
            "gripperAction",
            GripperSettings.USUAL.action(),
            "The action (control_msgs/GripperCommand) of a gripper's paddles, in each robot's namespace.");
    private static final Parameter<String> GRIPPER_JOINT = Parameter.text(
            "gripperJoint", GripperSettings.USUAL.joint(), "The joint of the paddles, as joint_states names it.");
    private static final Parameter<String> GRIPPER_POSITIONS = Parameter.text(
            "gripperPositions",
            "",
            "Positions of that joint when the paddles are open and when they are closed, such as 0.025 -0.015. Default: the"
                    + " opening of the robot's model, and 0.");
    private static final Parameter<Double> GRIPPER_EFFORT = Parameter.number(
            "gripperEffort", 0, 0, 10_000, "N", "The maximum effort of a gripper; 0: the limit of its controller.");
    private static final Parameter<String> LIFT_ACTION = Parameter.text(
            "liftAction",
            GripperSettings.USUAL.liftAction(),
            "The action (control_msgs/GripperCommand) of a gripper's lift, in each robot's namespace, if it has one.");
    private static final Parameter<String> LIFT_JOINT = Parameter.text(
            "liftJoint", GripperSettings.USUAL.liftJoint(), "The joint of the lift, as joint_states names it.");

    private static final Parameter<String> BUMPER_TOPICS = Parameter.text(
            "bumperTopics",
            "",
            "Topics (std_msgs/Bool) of bumpers in each robot's namespace, in the order of its model, separated by commas:"
                    + " bump_left, bump_right. Default: bumper_0, bumper_1, ... by the name of the device.");

    @Override
    public String key() {
        return "ros2";
    }

    @Override
    public String description() {
        return "Connects to robots of ROS 2 by DDS or rosbridge, and to those of ROS 1 by rosbridge. This machine needs no ROS.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return false;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(
                NAMESPACES,
                DOMAIN,
                ADDRESS,
                PEERS,
                ROSBRIDGE,
                ROSBRIDGE_ENCODING,
                ROSBRIDGE_RATE,
                DISTRIBUTION,
                RealRobots.WATCHDOG,
                RealRobots.ARMED,
                RealRobots.WAIT,
                RealRobots.LATE,
                DIAGNOSTICS,
                USE_SIM_TIME,
                STOP_TOPIC,
                STOP_SERVICE,
                GRIPPER_ACTION,
                GRIPPER_JOINT,
                GRIPPER_POSITIONS,
                GRIPPER_EFFORT,
                LIFT_ACTION,
                LIFT_JOINT,
                BUMPER_TOPICS);
    }

    @Override
    public boolean startsDisarmed(Arguments settings) {
        return !settings.get(RealRobots.ARMED);
    }

    @Override
    public boolean drivesTime(Arguments settings) {
        return settings.get(USE_SIM_TIME);
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        Arguments settings = config.settings();
        var problems = new ArrayList<Problem>();
        for (RobotSpec robot : config.robots()) {
            for (Part part : robot.model().sensors().values()) {
                if (!RosRobot.has(part)) {
                    problems.add(new Problem(
                            robot.id(),
                            "model",
                            "Robots of ROS 2 can't have '%s'. They can have lasers, sonars, bumpers, IMUs, batteries, cameras, blob detectors, grippers, maps, localizers, navigators, planners, docking."
                                    .formatted(part.name())));
                }
            }
        }
        try {
            Map<RobotSpec, String> namespaces = namespaces(settings, config.robots());
            Opening opening = opening(settings, scheduler);
            GripperSettings gripper = gripper(settings);
            if (problems.isEmpty()) {
                return new Ros2System(
                        namespaces,
                        networkName(settings),
                        opening,
                        distribution(settings),
                        new RosSettings(
                                new Safety(
                                        settings.seconds(RealRobots.WATCHDOG),
                                        settings.get(RealRobots.ARMED),
                                        settings.get(STOP_TOPIC),
                                        settings.get(STOP_SERVICE)),
                                gripper,
                                list(settings.get(BUMPER_TOPICS)),
                                settings.get(DIAGNOSTICS),
                                settings.get(USE_SIM_TIME)),
                        RealRobots.Waiting.of(settings),
                        scheduler,
                        new SecureRandom());
            }
        } catch (IllegalArgumentException e) {
            String robot =
                    config.robots().isEmpty() ? "" : config.robots().getFirst().id();
            problems.add(new Problem(robot, "mrs", String.valueOf(e.getMessage())));
        }
        throw new InvalidRobots(problems);
    }

    private static Optional<Distribution> distribution(Arguments settings) {
        return Arrays.stream(Distribution.values())
                .filter(each -> each.words().equals(settings.get(DISTRIBUTION)))
                .findFirst();
    }

    /// For people.
    private static String networkName(Arguments settings) {
        return settings.get(ROSBRIDGE).isBlank()
                ? "domain %d".formatted(network(settings, NODE).domain())
                : "rosbridge at '%s'".formatted(settings.get(ROSBRIDGE).strip());
    }

    private static Opening opening(Arguments settings, Scheduler scheduler) {
        if (settings.get(ROSBRIDGE).isBlank()) {
            UdpParticipant.Options network = network(settings, NODE);
            return () -> RosNetwork.join(network, Distribution.JAZZY, NODE);
        }
        RosbridgeOptions options = rosbridge(settings);
        return () -> new RosbridgeLink(new WebSocketTransport(options.address()), options, scheduler.inRealTime());
    }

    static RosbridgeOptions rosbridge(Arguments settings) {
        double rate = settings.get(ROSBRIDGE_RATE);
        return new RosbridgeOptions(
                rosbridgeAddress(settings),
                settings.get(ROSBRIDGE_ENCODING).equals(CBOR) ? Encoding.CBOR : Encoding.JSON,
                rate == 0 ? Duration.ZERO : Duration.ofMillis(Math.round(1_000 / rate)),
                distribution(settings));
    }

    /// @throws IllegalArgumentException when it is none, or settings of DDS are there, too
    static URI rosbridgeAddress(Arguments settings) {
        if (settings.get(DOMAIN) != FROM_ENVIRONMENT
                || !settings.get(ADDRESS).isBlank()
                || !settings.get(PEERS).isBlank()) {
            throw new IllegalArgumentException(
                    "'domain', 'address' and 'peers' are of DDS, which 'rosbridge' replaces. Remove them, or 'rosbridge'.");
        }
        return RosbridgeAddress.parse(settings.get(ROSBRIDGE));
    }

    private static GripperSettings gripper(Arguments settings) {
        Optional<double[]> positions = positions(settings.get(GRIPPER_POSITIONS).strip());
        return new GripperSettings(
                settings.get(GRIPPER_ACTION),
                settings.get(GRIPPER_JOINT),
                positions.map(both -> OptionalDouble.of(both[0])).orElseGet(OptionalDouble::empty),
                positions.map(both -> both[1]).orElse(0.0),
                settings.get(GRIPPER_EFFORT),
                settings.get(LIFT_ACTION),
                settings.get(LIFT_JOINT));
    }

    /// Open and closed; empty when they are not given.
    private static Optional<double[]> positions(String text) {
        if (text.isEmpty()) {
            return Optional.empty();
        }
        try {
            double[] both = Arrays.stream(text.split("\\s+", -1))
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            if (both.length == 2 && Double.isFinite(both[0] + both[1]) && both[0] != both[1]) {
                return Optional.of(both);
            }
        } catch (NumberFormatException _) {
            // the same message as for too many numbers
        }
        throw new IllegalArgumentException(
                "'gripperPositions' must be two different numbers, open and closed, such as 0.025 -0.015, not '%s'."
                        .formatted(text));
    }

    /// @param node as tools show it
    static UdpParticipant.Options network(Arguments settings, String node) {
        RosEnvironment environment = RosNetwork.environment();
        int domain =
                settings.get(DOMAIN) == FROM_ENVIRONMENT ? environment.domain().orElse(0) : settings.get(DOMAIN);
        List<InetAddress> addresses = list(settings.get(ADDRESS)).stream()
                .map(address -> RosNetwork.machine("address", address))
                .toList();
        return RosNetwork.options(domain, addresses, list(settings.get(PEERS)), environment, node);
    }

    private static List<String> list(String text) {
        return text.isBlank() ? List.of() : List.of(text.strip().split("\\s*,\\s*", -1));
    }

    private static Map<RobotSpec, String> namespaces(Arguments settings, List<RobotSpec> robots) {
        List<String> given = list(settings.get(NAMESPACES));
        List<String> all = given.isEmpty()
                ? robots.stream().map(robot -> RosNetwork.namespace(robot.id())).toList()
                : given;
        if (all.size() < robots.size()) {
            throw new IllegalArgumentException(
                    "As many 'namespaces' as robots are needed: %d, not %d.".formatted(robots.size(), all.size()));
        }
        var namespaces = new LinkedHashMap<RobotSpec, String>();
        for (int i = 0; i < robots.size(); i++) {
            String namespace = all.get(i).startsWith("/") ? all.get(i) : "/" + all.get(i);
            if (!NAMESPACE.matcher(namespace).matches()) {
                throw new IllegalArgumentException(
                        "'%s' is not a namespace of ROS 2. Write one such as /robot1.".formatted(namespace));
            }
            if (namespaces.containsValue(namespace)) {
                throw new IllegalArgumentException("Two robots have the namespace '%s'.".formatted(namespace));
            }
            namespaces.put(robots.get(i), namespace);
        }
        return namespaces;
    }
}
