package rsal.ros2.system;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import rsal.ros2.link.RosEndpoint;
import rsal.system.Diagnosis.Finding;

/// Namespaces that have what a robot needs, or a part of it.
final class RobotFindings {
    private RobotFindings() {}

    static List<Finding> of(List<RosEndpoint> endpoints) {
        Map<String, Set<String>> topics = new TreeMap<>();
        for (RosEndpoint endpoint : endpoints) {
            String name = endpoint.topic().name();
            int slash = name.lastIndexOf('/');
            String type = endpoint.topic().type();
            boolean isOdometry = endpoint.isPublisher() && type.equals("nav_msgs/msg/Odometry");
            boolean isCommand = !endpoint.isPublisher() && name.endsWith("/cmd_vel");
            boolean isScan = endpoint.isPublisher() && type.equals("sensor_msgs/msg/LaserScan");
            if (isOdometry || isCommand || isScan) {
                topics.computeIfAbsent(slash == 0 ? "/" : name.substring(0, slash), _ -> new TreeSet<>())
                        .add(isOdometry ? "odometry" : isCommand ? "cmd_vel" : "scans");
            }
        }
        var findings = new ArrayList<Finding>();
        topics.forEach((namespace, has) -> {
            boolean isRobot = has.contains("odometry") && has.contains("cmd_vel");
            findings.add(new Finding(
                    "robot",
                    isRobot,
                    "'%s' has %s".formatted(namespace, String.join(", ", has)),
                    isRobot ? "" : "A robot needs somebody who publishes odometry, and who subscribes to cmd_vel."));
        });
        return findings;
    }
}
