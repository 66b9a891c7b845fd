package rsal.ros2.system;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.rosbridge.RosbridgeLink;
import rsal.ros2.rosbridge.RosbridgeOptions;
import rsal.ros2.rosbridge.RosbridgeOptions.Encoding;
import rsal.ros2.rosbridge.WebSocketTransport;
import rsal.settings.Arguments;
import rsal.system.Diagnosis.Finding;
import rsal.time.AllowedToReadWallClock;
import rsal.time.WallScheduler;

/// Whether a server of rosbridge is there, and which robots are behind it.
@AllowedToReadWallClock("Networks live in real time.")
final class RosbridgeFindings {
    private RosbridgeFindings() {}

    /// @param time to look
    static List<Finding> of(Arguments settings, Duration time) {
        var options = new RosbridgeOptions(
                Ros2Provider.rosbridgeAddress(settings), Encoding.CBOR, Duration.ZERO, Optional.empty());
        var findings = new ArrayList<Finding>();
        try (var scheduler = new WallScheduler("doctor", Runnable::run)) {
            var opened = new ArrayList<RosbridgeLink>();
            scheduler.exclusively(
                    () -> opened.add(new RosbridgeLink(new WebSocketTransport(options.address()), options, scheduler)));
            RosbridgeLink link = opened.getFirst();
            try {
                Thread.sleep(time);
                findings.addAll(of(link, options, time));
            } finally {
                scheduler.exclusively(link::close);
            }
        } catch (InterruptedException e) {
            Thread.currentThread().interrupt();
        }
        return findings;
    }

    private static List<Finding> of(RosbridgeLink link, RosbridgeOptions options, Duration time) {
        Optional<String> trouble = link.trouble();
        if (trouble.isPresent()) {
            return List.of(new Finding(
                    "rosbridge",
                    false,
                    trouble.get(),
                    "On the robot: ros2 launch rosbridge_server rosbridge_websocket_launch.xml"));
        }
        if (!link.hasAnswered()) {
            return List.of(new Finding(
                    "rosbridge",
                    false,
                    "'%s' does not answer within %.0f s".formatted(options.address(), time.toMillis() / 1e3),
                    "Is it rosbridge? Slow robots need more time: --set time=20"));
        }
        var findings = new ArrayList<Finding>();
        findings.add(new Finding("rosbridge", true, "answers at '%s'".formatted(options.address()), ""));
        List<RosEndpoint> endpoints = link.endpoints();
        if (endpoints.isEmpty()) {
            findings.add(new Finding(
                    "topics", false, "none", "Do the robot's drivers run? Maybe look longer: --set time=20"));
        }
        findings.addAll(RobotFindings.of(endpoints));
        return findings;
    }
}
