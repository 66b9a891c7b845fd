package rsal.ros2.bridge;

import java.time.Duration;
import java.util.Collection;
import java.util.List;
import java.util.function.Supplier;
import rsal.device.Device;
import rsal.device.Health;
import rsal.robot.Robot;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// How all devices of all robots are, once a second, as `/diagnostics` (REP 107).
final class PublishedHealth {
    private static final Duration PERIOD = Duration.ofSeconds(1);

    private final Supplier<Collection<Robot>> robots;
    private final Scheduler scheduler;
    private final Publication diagnostics;
    private final Task publishing;

    /// @param robots that there are now
    PublishedHealth(Supplier<Collection<Robot>> robots, RosLink link, Scheduler scheduler) {
        this.robots = robots;
        this.scheduler = scheduler;
        diagnostics =
                link.advertise(new RosTopic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"), Profile.DEFAULT);
        publishing = scheduler.every(PERIOD, Phase.OBSERVE, this::publish);
    }

    private void publish() {
        List<Device> devices =
                robots.get().stream().flatMap(robot -> robot.devices().stream()).toList();
        CdrWriter array =
                RosMessages.write(new CdrWriter(), scheduler.instant()).text("");
        array.int32(devices.size());
        devices.forEach(device -> write(array, device));
        diagnostics.publish(array.toBytes());
    }

    /// `diagnostic_msgs/DiagnosticStatus`
    private static void write(CdrWriter to, Device device) {
        String name = "%s: %s".formatted(device.info().robot(), device.info().name());
        switch (device.health()) {
            case Health.Ok _ -> to.int8((byte) 0).text(name).text("OK");
            case Health.Lost(String reason) -> to.int8((byte) 2).text(name).text(reason);
            case Health.Stale(String reason) -> to.int8((byte) 3).text(name).text(reason);
        }
        to.text(device.info().robot());
        to.int32(1).text("driver").text(device.info().driver());
    }

    void close() {
        publishing.cancel();
        diagnostics.close();
    }
}
