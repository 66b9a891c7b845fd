package rsal.ros2.bridge;

import java.time.Duration;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import rsal.robot.Robot;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.ExportedDevice;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// Publishes all robots for as long as it is open, and the run's time (`/clock`).
final class Ros2Bridge implements Bridge {
    private static final Duration TICK = Duration.ofMillis(10);

    private final RosLink link;
    private final BridgeContext context;
    private final int port;
    private final Scheduler scheduler;
    private final RosMessages messages = new RosMessages();
    private final Map<String, PublishedRobot> robots = new LinkedHashMap<>();
    private final Publication clock;
    private final Task ticking;
    private boolean closed;

    /// @param link which this closes
    /// @param port for people: where the domain's participants hear of each other
    Ros2Bridge(RosLink link, BridgeContext context, int port, Scheduler scheduler) {
        this.link = link;
        this.context = context;
        this.port = port;
        this.scheduler = scheduler;
        clock = link.advertise(new RosTopic("/clock", "rosgraph_msgs/msg/Clock"), Profile.SENSOR_DATA);
        ticking = scheduler.every(TICK, Phase.OBSERVE, this::tick);
        context.robots().forEach(this::join);
    }

    private void tick() {
        clock.publish(0, messages.clock(scheduler.instant()));
    }

    @Override
    public List<ExportedDevice> offers() {
        return robots.values().stream()
                .flatMap(robot -> robot.offers().stream())
                .toList();
    }

    @Override
    public List<ExportedDevice> join(Robot robot) {
        return robots.computeIfAbsent(robot.id(), _ -> new PublishedRobot(robot, context, link, port, scheduler))
                .offers();
    }

    @Override
    public void leave(String robot) {
        PublishedRobot gone = robots.remove(robot);
        if (gone != null) {
            gone.close();
        }
    }

    @Override
    public void close() {
        if (!closed) {
            closed = true;
            ticking.cancel();
            robots.values().forEach(PublishedRobot::close);
            robots.clear();
            link.close();
        }
    }
}
