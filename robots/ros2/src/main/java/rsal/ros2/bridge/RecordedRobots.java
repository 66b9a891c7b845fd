package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.simulation.PublishedTime;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.ExportedDevice;
import rsal.time.Phase;
import rsal.time.Scheduler;
import rsal.time.Task;

/// All robots of a run in one bag: each one's sensors in its namespace; the map, the time, and the frames of all on
/// `/map`, `/clock`, `/tf` and `/tf_static`, those of a robot with its namespace before their names. In simulated
/// worlds also where robots really are (`ground_truth`).
final class RecordedRobots implements Bridge {
    private static final Duration PERIOD = Duration.ofMillis(100); // of the time and the truth
    private static final String TRANSFORMS = "tf2_msgs/msg/TFMessage";

    private final BagPublisher bag;
    private final PublishedTime scheduler;
    private final Optional<SimulationControl> simulation;
    private final RosMessages messages = new RosMessages();
    private final Map<String, RobotPublications> robots = new LinkedHashMap<>();
    private final Map<String, Publication> truths = new LinkedHashMap<>(); // by robot
    private final Publication transforms;
    private final MountedFrames mounted;
    private final Publication clock;
    private final Task ticking;

    /// @param bag which this closes
    RecordedRobots(BagPublisher bag, BridgeContext context, Scheduler scheduler) {
        this.bag = bag;
        this.scheduler = new PublishedTime(scheduler);
        this.simulation = context.simulation();
        transforms = bag.advertise(new RosTopic("/tf", TRANSFORMS), Profile.DEFAULT);
        mounted = new MountedFrames(
                bag.advertise(new RosTopic("/tf_static", TRANSFORMS), Profile.LATCHED), transforms, this.scheduler);
        clock = bag.advertise(new RosTopic("/clock", "rosgraph_msgs/msg/Clock"), Profile.SENSOR_DATA);
        bag.advertise(new RosTopic("/map", "nav_msgs/msg/OccupancyGrid"), Profile.LATCHED)
                .publish(messages.map(scheduler.instant(), context.map(), FrameNames.PLAIN.map()));
        context.robots().forEach(this::join);
        ticking = scheduler.every(PERIOD, Phase.OBSERVE, this::tick);
    }

    private void tick() {
        Instant now = scheduler.instant();
        clock.publish(messages.clock(now));
        truths.forEach((robot, truth) -> simulation
                .flatMap(world -> world.truth(robot))
                .ifPresent(pose -> truth.publish(messages.pose(now, pose, FrameNames.PLAIN.map()))));
    }

    @Override
    public List<ExportedDevice> offers() {
        return List.of();
    }

    @Override
    public List<ExportedDevice> join(Robot robot) {
        String namespace = RosNetwork.namespace(robot.id());
        var names = new FrameNames(namespace.substring(1) + "/");
        var outlet = new RobotOutlet(robot, bag, namespace, names, mounted, (_, _) -> {}, _ -> true, scheduler);
        var sensors = new RobotPublications(outlet, transforms);
        robots.put(robot.id(), sensors);
        truths.put(
                robot.id(),
                bag.advertise(
                        new RosTopic(namespace + "/ground_truth", "geometry_msgs/msg/PoseStamped"), Profile.DEFAULT));
        sensors.begin();
        return List.of();
    }

    @Override
    public void leave(String robot) {
        RobotPublications gone = robots.remove(robot);
        truths.remove(robot);
        if (gone != null) {
            gone.close();
        }
    }

    @Override
    public void close() {
        ticking.cancel();
        robots.values().forEach(RobotPublications::close);
        robots.clear();
        bag.close();
    }
}
