package rsal.system;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.device.SimulationControl;
import rsal.robot.Robot;
import rsal.scene.RobotService;
import rsal.time.Scheduler;

/// A way to offer the robots of a run, whatever robot system they are of, to programs that speak another
/// system's protocol. Found by [java.util.ServiceLoader] and named by its key (`rsal bridge player`). What each
/// owes to the robots that its clients drive says `rsal.testkit.contract.CommandTimeoutContract`.
public interface BridgeProvider {
    /// `player`
    String key();

    /// For people: a sentence.
    String description();

    /// Where those programs look when they are told nothing else.
    int defaultPort();

    /// Offers what a run lends from now on. Called on the scheduler's thread.
    ///
    /// @param at where to listen: at this port, and those after it if need be; port 0 for any that are free
    /// @throws IOException when nobody may listen there; its message is a sentence that says where
    Bridge open(InetSocketAddress at, Lent lent, Scheduler scheduler) throws IOException;

    /// What a run lends.
    ///
    /// @param robots that are there now, with all their devices
    /// @param map what robots know of the world that have been told
    /// @param simulation the truth, where the world is a simulated one
    /// @param services that the world's file asks for; empty when it asks for none, which is for all there is
    /// @param timeout of clients' commands
    record Lent(
            List<Robot> robots,
            OccupancyGrid map,
            Optional<SimulationControl> simulation,
            List<RobotService> services,
            CommandTimeout timeout) {
        public Lent {
            robots = List.copyOf(robots);
            services = List.copyOf(services);
        }

        /// To clients whose commands hold until others come.
        public Lent(
                List<Robot> robots,
                OccupancyGrid map,
                Optional<SimulationControl> simulation,
                List<RobotService> services) {
            this(robots, map, simulation, services, CommandTimeout.none());
        }
    }
}
