package rsal.system;

import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.scene.RobotService;

/// What a run lets a [Bridge] offer.
///
/// @param robots that are there now, with all their devices
/// @param map what robots know of the world that have been told
/// @param simulation the truth, where the world is a simulated one
/// @param services that the world's file asks for; empty when it asks for none, which is for all there is
/// @param timeout of clients' commands
/// @param control of the run itself; empty where programs may only drive robots
/// @param isPaced whether simulated time waits for programs that follow it ([Bridge#pace])
public record BridgeContext(
        List<Robot> robots,
        OccupancyGrid map,
        Optional<SimulationControl> simulation,
        List<RobotService> services,
        CommandTimeout timeout,
        Optional<RunControl> control,
        boolean isPaced) {
    public BridgeContext {
        robots = List.copyOf(robots);
        services = List.copyOf(services);
    }

    /// Without control of the run.
    public BridgeContext(
            List<Robot> robots,
            OccupancyGrid map,
            Optional<SimulationControl> simulation,
            List<RobotService> services,
            CommandTimeout timeout) {
        this(robots, map, simulation, services, timeout, Optional.empty(), false);
    }

    /// To clients whose commands hold until others come, without control of the run.
    public BridgeContext(
            List<Robot> robots,
            OccupancyGrid map,
            Optional<SimulationControl> simulation,
            List<RobotService> services) {
        this(robots, map, simulation, services, CommandTimeout.none());
    }
}
