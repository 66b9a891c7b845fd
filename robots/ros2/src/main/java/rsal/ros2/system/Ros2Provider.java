package rsal.ros2.system;

import java.net.InetAddress;
import java.security.SecureRandom;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.ros2.device.RosRobot;
import rsal.ros2.device.Safety;
import rsal.ros2.link.RosEnvironment;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.type.Distribution;
import rsal.rtps.UdpParticipant;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.system.RealRobots;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.system.RobotSystemProvider.InvalidRobots.Problem;
import rsal.time.Scheduler;

/// Robots of ROS 2, real ones or those of another simulator. They follow real time.
public final class Ros2Provider implements RobotSystemProvider {
    private static final String NODE = "rsal";
    private static final Pattern NAMESPACE = Pattern.compile("/|(/[A-Za-z_][A-Za-z0-9_]*)+");
    private static final int FROM_ENVIRONMENT = -1;
    private static final String ANNOUNCED = "announced";

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
    private static final Parameter<String> DISTRIBUTION = Parameter.choice(
            "distribution",
            ANNOUNCED,
            Stream.concat(
                            Stream.of(ANNOUNCED),
                            Arrays.stream(Distribution.values()).map(Distribution::words))
                    .toList(),
            "The distribution of ROS 2 that the robots run. announced: the one that each robot announces.");

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

    @Override
    public String key() {
        return "ros2";
    }

    @Override
    public String description() {
        return "Connects to robots of ROS 2 over the network (DDS). This machine needs no ROS.";
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
                DISTRIBUTION,
                RealRobots.WATCHDOG,
                RealRobots.ARMED,
                STOP_TOPIC,
                STOP_SERVICE);
    }

    @Override
    public boolean startsDisarmed(Arguments settings) {
        return !settings.get(RealRobots.ARMED);
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
                            "Robots of ROS 2 can't have its '%s' yet: lasers, sonars, batteries, maps, localizers, navigators are."
                                    .formatted(part.name())));
                }
            }
        }
        try {
            Map<RobotSpec, String> namespaces = namespaces(settings, config.robots());
            UdpParticipant.Options network = network(settings, NODE);
            if (problems.isEmpty()) {
                Optional<Distribution> distribution = Arrays.stream(Distribution.values())
                        .filter(each -> each.words().equals(settings.get(DISTRIBUTION)))
                        .findFirst();
                return new Ros2System(
                        namespaces,
                        () -> RosNetwork.join(network, Distribution.JAZZY, NODE),
                        distribution,
                        new Safety(
                                settings.seconds(RealRobots.WATCHDOG),
                                settings.get(RealRobots.ARMED),
                                settings.get(STOP_TOPIC),
                                settings.get(STOP_SERVICE)),
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
                        "'%s' is no namespace of ROS 2. Write one such as /robot1.".formatted(namespace));
            }
            if (namespaces.containsValue(namespace)) {
                throw new IllegalArgumentException("Two robots have the namespace '%s'.".formatted(namespace));
            }
            namespaces.put(robots.get(i), namespace);
        }
        return namespaces;
    }
}
