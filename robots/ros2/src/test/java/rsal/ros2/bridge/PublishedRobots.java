package rsal.ros2.bridge;

import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.ros2.link.RosLink;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.CommandTimeout;
import rsal.system.RunControl;
import rsal.time.Scheduler;

/// Opens the bridge on any link, for tests of other packages.
public final class PublishedRobots {
    private PublishedRobots() {}

    public static Bridge publish(List<Robot> robots, OccupancyGrid map, RosLink link, Scheduler scheduler) {
        return publish(robots, map, link, CommandTimeout.none(), scheduler);
    }

    public static Bridge publish(
            List<Robot> robots, OccupancyGrid map, RosLink link, CommandTimeout timeout, Scheduler scheduler) {
        return new Ros2Bridge(
                link, new BridgeContext(robots, map, Optional.empty(), List.of(), timeout), 7400, scheduler);
    }

    /// Also so that programs that follow the run's time hold it back.
    static Bridge publishPaced(
            List<Robot> robots, OccupancyGrid map, RosLink link, CommandTimeout timeout, Scheduler scheduler) {
        var context = new BridgeContext(robots, map, Optional.empty(), List.of(), timeout, Optional.empty(), true);
        return new Ros2Bridge(link, context, 7400, scheduler);
    }

    /// Also with control of the run.
    static Bridge publish(
            List<Robot> robots,
            OccupancyGrid map,
            SimulationControl world,
            RunControl control,
            RosLink link,
            Scheduler scheduler) {
        var context = new BridgeContext(
                robots, map, Optional.of(world), List.of(), CommandTimeout.none(), Optional.of(control), false);
        return new Ros2Bridge(link, context, 7400, scheduler);
    }
}
