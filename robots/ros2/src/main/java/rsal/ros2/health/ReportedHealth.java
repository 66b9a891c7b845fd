package rsal.ros2.health;

import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.device.DeviceCore;
import rsal.device.Health;
import rsal.ros2.link.RosLink;
import rsal.time.Scheduler;

/// How a robot's own programs say that its devices are: by its diagnostics, and by the states of the nodes of Nav2 that
/// a device needs. A device whose nodes are not active is lost.
public final class ReportedHealth {
    private final String namespace;
    private final RosLink link;
    private final Scheduler scheduler;
    private final Optional<RobotReports> diagnostics;
    private final Map<String, LifecycleNode> nodes = new HashMap<>(); // by their names
    private final List<Reported> devices = new ArrayList<>();

    /// @param needs nodes, of each list one
    private record Reported(DeviceCore device, List<List<LifecycleNode>> needs) {}

    /// @param namespace of the robot; empty for none
    /// @param diagnostics empty where they do not matter
    public ReportedHealth(String namespace, RosLink link, Scheduler scheduler, Optional<RobotReports> diagnostics) {
        this.namespace = namespace;
        this.link = link;
        this.scheduler = scheduler;
        this.diagnostics = diagnostics;
    }

    public void add(DeviceCore device, ReportNames names) {
        diagnostics.ifPresent(reports -> reports.add(device.info().name(), names.words()));
        List<List<LifecycleNode>> needs = names.nodes().stream()
                .map(either -> either.stream().map(this::node).toList())
                .toList();
        devices.add(new Reported(device, needs));
    }

    private LifecycleNode node(String name) {
        return nodes.computeIfAbsent(name, _ -> new LifecycleNode(namespace + "/" + name, link, scheduler));
    }

    public void look(Instant now) {
        nodes.values().forEach(node -> node.look(now));
        devices.forEach(each -> each.device.report(trouble(each.needs)
                .<Health>map(Health.Lost::new)
                .or(() -> diagnostics.flatMap(
                        reports -> reports.health(each.device.info().name(), now)))));
    }

    /// The first need that no node meets, though there is one whose state is known.
    private static Optional<String> trouble(List<List<LifecycleNode>> needs) {
        return needs.stream()
                .filter(either -> either.stream().noneMatch(LifecycleNode::isActive))
                .flatMap(List::stream)
                .flatMap(node -> node.trouble().stream())
                .findFirst();
    }

    public void close() {
        nodes.values().forEach(LifecycleNode::close);
        diagnostics.ifPresent(RobotReports::close);
    }
}
