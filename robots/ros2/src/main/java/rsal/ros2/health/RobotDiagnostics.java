package rsal.ros2.health;

import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// What programs say of the hardware of robots as `diagnostic_msgs/DiagnosticArray` (REP 107): in a robot's namespace,
/// or on `/diagnostics` for all robots. There, a status is of the robot whose namespace its `hardware_id` or its name
/// has. A robot without a namespace has all that are of no other robot. What is of no robot is passed over.
public final class RobotDiagnostics {
    private static final String TYPE = "diagnostic_msgs/msg/DiagnosticArray"; // the same in all distributions
    private static final String TOPIC = "/diagnostics";
    private static final int WAITING = 50; // messages, as each program publishes its own

    private final RosLink link;
    private final Scheduler scheduler;
    private final MessageCodec codec;
    private final Subscribed shared;
    private final Map<String, RobotReports> robots = new LinkedHashMap<>(); // by namespaces

    public RobotDiagnostics(RosLink link, Scheduler scheduler) {
        this.link = link;
        this.scheduler = scheduler;
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        codec = MessageCodec.of(types.get(TYPE), types);
        shared = subscribe(
                TOPIC,
                message -> message.messages("status")
                        .forEach(status -> robot(status).ifPresent(robot -> robot.take(status))));
    }

    private Subscribed subscribe(String topic, Consumer<RosMessage> receiver) {
        return link.subscribe(
                new RosTopic(topic, TYPE), Profile.SENSOR_DATA, new Inbox<>(WAITING, codec::read, scheduler, receiver));
    }

    /// Begins with a robot.
    ///
    /// @param namespace empty for none
    public RobotReports robot(String namespace) {
        var reports = new RobotReports(namespace, scheduler);
        robots.put(namespace, reports);
        if (!namespace.isEmpty()) {
            Subscribed own = subscribe(
                    namespace + TOPIC, message -> message.messages("status").forEach(reports::take));
            reports.onClose(own::close);
        }
        reports.onClose(() -> robots.remove(namespace));
        return reports;
    }

    private Optional<RobotReports> robot(RosMessage status) {
        String hardware = status.text("hardware_id").strip();
        Optional<RobotReports> meant = Optional.empty();
        if (!hardware.isEmpty()) {
            String namespace = hardware.startsWith("/") ? hardware : RosNetwork.namespace(hardware);
            meant = Optional.ofNullable(robots.get(namespace));
        }
        return meant.or(() -> byName(status.text("name"))).or(() -> Optional.ofNullable(robots.get("")));
    }

    /// @param name where it has a namespace: `/robot1/laser: scan`
    private Optional<RobotReports> byName(String name) {
        for (int slash = name.indexOf('/', 1);
                name.startsWith("/") && slash > 0;
                slash = name.indexOf('/', slash + 1)) {
            RobotReports robot = robots.get(name.substring(0, slash));
            if (robot != null) {
                return Optional.of(robot);
            }
        }
        return Optional.empty();
    }

    public void close() {
        shared.close();
    }
}
