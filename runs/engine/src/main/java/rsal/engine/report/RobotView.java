package rsal.engine.report;

import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import rsal.data.GripperState;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.SimulationControl.Carried;

/// A robot as people see it: the newest of everything it has.
///
/// @param color `#rrggbb`
/// @param model name of its model
/// @param gone whether a fault has taken it away
/// @param goneFor for how long nobody has told where one that is gone is; empty when it is there, or nobody
///         ever has
/// @param truth where it really is, in the map frame; empty where nobody knows
/// @param map as it has drawn it itself so far, in the map frame
/// @param path the way its navigator intends to take
/// @param localPath how it means to get on along that way next, as [rsal.device.Navigator#localPath] has it
/// @param goal where its navigator drives to
/// @param inCharge name of the behavior that drives it, or of its navigator; empty when an agent drives it, or
///         a person, or nobody, as when it is gone
/// @param behavior what a person told it to do, as [rsal.engine.RunOperator#behave] has it; empty when nobody
///         did
/// @param driver who drives it by keys, as [rsal.engine.RunOperator#drive] has it; empty when nobody does
/// @param stopped whether its motors are off until people switch them on
/// @param switchedOff whether they are for this one alone, and stay so when an emergency stop ends
/// @param lit whether its light shines
/// @param carried what of it its actuators have carried elsewhere; pieces by their numbers in [Teammate#body]
/// @param real what there is to say of one that is not simulated; else empty
/// @param readings what its devices have told last, in their order; as [rsal.engine.RunInspector#readings] has
///         it
public record RobotView(
        String id,
        String role,
        String color,
        String model,
        boolean gone,
        Optional<Duration> goneFor,
        Optional<Pose2d> truth,
        Optional<Stamped<Odometry>> odometry,
        Optional<Stamped<PoseEstimate>> estimate,
        Optional<Stamped<ParticleCloud>> particles,
        Optional<Stamped<LaserScan>> scan,
        Optional<Stamped<RangeArray>> ranges,
        Optional<Stamped<OccupancyGrid>> map,
        Path2d path,
        Path2d localPath,
        Optional<Pose2d> goal,
        String inCharge,
        String behavior,
        String driver,
        Optional<Stamped<GripperState>> gripper,
        boolean stopped,
        boolean switchedOff,
        boolean lit,
        List<Carried> carried,
        Optional<Real> real,
        List<DeviceView> devices,
        List<Reading> readings) {
    public RobotView {
        carried = List.copyOf(carried);
        devices = List.copyOf(devices);
        readings = List.copyOf(readings);
    }

    /// A map that a robot has drawn itself.
    ///
    /// @param device that drew it; empty where that is not known
    public record Drawn(String device, Stamped<OccupancyGrid> map) {}

    /// All maps that it has drawn so far: [#map], then those of other devices, in their order.
    public List<Drawn> maps() {
        var maps = new ArrayList<Drawn>();
        map.ifPresent(first -> maps.add(new Drawn("", first)));
        for (Reading reading : readings) {
            if (reading.value().value() instanceof OccupancyGrid grid) {
                var reported =
                        new Stamped<>(reading.value().time(), reading.value().frame(), grid);
                if (!maps.isEmpty() && maps.getFirst().map().equals(reported)) {
                    maps.set(0, new Drawn(reading.device(), reported));
                } else {
                    maps.add(new Drawn(reading.device(), reported));
                }
            }
        }
        return maps;
    }

    /// A robot of a system that does not simulate.
    ///
    /// @param proxy whether it is to have a stand-in in the simulated world
    /// @param standIn where that is, in the map frame; empty while there is none
    /// @param silence for how long nobody has told where it is; empty when nobody ever has
    public record Real(boolean proxy, Optional<Pose2d> standIn, Optional<Duration> silence) {}
}
