package rsal.ros2.system;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import rsal.ros2.device.RobotTopics;
import rsal.ros2.device.RosRobot;
import rsal.ros2.link.RosEndpoint;
import rsal.system.Diagnosis.Finding;

/// Namespaces that have what a robot needs, or a part of it. Whether one is a robot is decided as runs do
/// ([RosRobot#lacking]); what is in a namespace below that of a robot belongs to it.
final class RobotFindings {
    private RobotFindings() {}

    static List<Finding> of(List<RosEndpoint> endpoints) {
        Map<String, Set<String>> parts = parts(endpoints);
        var robots = new TreeSet<String>();
        for (String namespace : parts.keySet()) { // the outer ones first
            if (robots.stream().noneMatch(robot -> isBelow(robot, namespace))
                    && lacking(namespace, endpoints).isEmpty()) {
                robots.add(namespace);
            }
        }
        var findings = new ArrayList<Finding>();
        parts.forEach((namespace, has) -> {
            if (robots.contains(namespace)) {
                var all = new TreeSet<String>();
                parts.forEach((other, its) -> {
                    if (other.equals(namespace) || isBelow(namespace, other)) {
                        all.addAll(its);
                    }
                });
                findings.add(finding(namespace, true, all, ""));
            } else if (robots.stream().noneMatch(robot -> isBelow(robot, namespace))) {
                String lacking = String.join(" and ", lacking(namespace, endpoints));
                findings.add(finding(
                        namespace, false, has, "It is not a robot that can be driven: it lacks " + lacking + "."));
            }
        });
        return findings;
    }

    private static Finding finding(String namespace, boolean isRobot, Set<String> has, String remedy) {
        return new Finding("robot", isRobot, "'%s' has %s".formatted(namespace, String.join(", ", has)), remedy);
    }

    /// What robots have, by namespaces, in their order.
    private static Map<String, Set<String>> parts(List<RosEndpoint> endpoints) {
        Map<String, Set<String>> parts = new TreeMap<>();
        for (RosEndpoint endpoint : endpoints) {
            String name = endpoint.topic().name();
            int slash = name.lastIndexOf('/');
            String type = endpoint.topic().type();
            boolean isOdometry = endpoint.isPublisher() && type.equals("nav_msgs/msg/Odometry");
            boolean isCommand = !endpoint.isPublisher() && name.endsWith("/cmd_vel");
            boolean isScan = endpoint.isPublisher() && type.equals("sensor_msgs/msg/LaserScan");
            if (isOdometry || isCommand || isScan) {
                parts.computeIfAbsent(slash == 0 ? "/" : name.substring(0, slash), _ -> new TreeSet<>())
                        .add(isOdometry ? "odometry" : isCommand ? "cmd_vel" : "scans");
            }
        }
        return parts;
    }

    private static boolean isBelow(String outer, String inner) {
        return !outer.equals("/") && inner.startsWith(outer + "/");
    }

    private static List<String> lacking(String namespace, List<RosEndpoint> endpoints) {
        return RosRobot.lacking(new RobotTopics(namespace.equals("/") ? "" : namespace, endpoints));
    }
}
