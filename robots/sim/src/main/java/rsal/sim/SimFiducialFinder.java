package rsal.sim;

import java.time.Instant;
import java.util.List;
import java.util.OptionalInt;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.FiducialFinder;
import rsal.robot.RobotModel.Part;
import rsal.sim.world.Body;
import rsal.sim.world.MarkerSearch;
import rsal.sim.world.World;

/// A simulated finder of markers, exact. It sees a marker when the level ray towards the origin of its body meets that
/// body first, as in Stage: those behind others it does not see, and those that are higher or lower than it only if
/// it is made for all heights. Then nothing at its own height may be in between.
final class SimFiducialFinder extends SimRangeSensor<Fiducials> implements FiducialFinder {
    private static final int RAYS = 10; // as many as a reading is worth, roughly

    private final Part.FiducialFinder part;
    private final double height;

    /// @param height above the base [m]
    SimFiducialFinder(DeviceInfo info, Part.FiducialFinder part, double height, DeviceMount mount) {
        super(info, info.robot() + "/base_link", part.period(), mount);
        this.part = part;
        this.height = height;
    }

    @Override
    int rays() {
        return RAYS;
    }

    @Override
    Fiducials measure(World world, Body robot, Instant now) {
        Pose2d mapFromBase = robot.seenPose();
        Pose2d baseFromMap = mapFromBase.inverse();
        Pose2d baseFromFinder = shift().moved(part.baseFromFinder());
        List<Fiducial> fiducials = MarkerSearch.markers(
                        world,
                        robot,
                        mapFromBase.compose(baseFromFinder),
                        robot.height() + height + shift().rise(),
                        part.fieldOfView(),
                        part.rangeMax(),
                        part.key(),
                        part.allHeights())
                .stream()
                .map(found -> new Fiducial(
                        found.distance() <= part.idRange() ? OptionalInt.of(found.id()) : OptionalInt.empty(),
                        baseFromMap.compose(found.mapFromMarker())))
                .toList();
        return new Fiducials(baseFromFinder, part.fieldOfView(), part.rangeMax(), fiducials);
    }
}
