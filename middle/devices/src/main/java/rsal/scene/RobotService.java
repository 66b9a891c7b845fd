package rsal.scene;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.device.Navigator.Tolerance;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Value;

/// What the file of a world asks a robot server to offer at a port: devices of a driver.
///
/// @param driver `stage`, `amcl`
/// @param location of the driver in its file
/// @param port of the server
/// @param devices that it offers there, `position2d:0`
/// @param needs devices of others that it works with, with their ports, `6665:laser:0`
/// @param robot whose devices they are, by id; empty when they are no robot's
/// @param sources names of the robot's devices that those offered are, by the names of these, or [#MAP] or
/// [#SIMULATION]; what is not named is nothing that there is here
/// @param software devices that the robot has to be given for it, in the order in which they are made
/// @param tolerance when a robot is near enough to where clients send it
/// @param refusal why it can't be offered; empty when it can
public record RobotService(
        String driver,
        Location location,
        int port,
        List<String> devices,
        List<String> needs,
        Optional<String> robot,
        Map<String, String> sources,
        List<Software> software,
        Tolerance tolerance,
        Optional<Problem> refusal) {
    /// The source that is the map of the world.
    public static final String MAP = "map";

    /// The source that is the truth of the world.
    public static final String SIMULATION = "simulation";

    public RobotService {
        devices = List.copyOf(devices);
        needs = List.copyOf(needs);
        sources = Collections.unmodifiableMap(new LinkedHashMap<>(sources));
        software = List.copyOf(software);
    }

    /// A device that is made from a robot's others.
    ///
    /// @param name of the device, `localizer`
    /// @param driver that makes it, by key: `amcl`
    /// @param settings of that driver
    /// @param mapFromStart where it is told that its robot starts; empty for where that does
    public record Software(String name, String driver, Value.Mapping settings, Optional<Pose2d> mapFromStart) {
        /// One that is told where its robot starts.
        public Software(String name, String driver, Value.Mapping settings) {
            this(name, driver, settings, Optional.empty());
        }
    }
}
