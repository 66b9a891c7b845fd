package rsal.player.device;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import rsal.data.Fiducials;
import rsal.data.Pose2d;
import rsal.device.DeviceInfo;
import rsal.device.FiducialFinder;
import rsal.player.message.Fiducial;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Part;

/// A finder of markers behind `fiducial`. Where it is mounted and how far it sees is what the server says; of what
/// that does not say, what the robot's model says.
final class PlayerMarkers extends PlayerSensor<Fiducials> implements FiducialFinder {
    private Pose2d baseFromFinder;
    private double fieldOfView;
    private double rangeMax;

    PlayerMarkers(DeviceInfo info, Address address, Part.FiducialFinder part) {
        super(info, address, info.robot() + "/base_link");
        this.baseFromFinder = part.baseFromFinder();
        this.fieldOfView = part.fieldOfView();
        this.rangeMax = part.rangeMax();
    }

    @Override
    public List<Integer> questions() {
        return List.of(Fiducial.GEOMETRY, Fiducial.VIEW);
    }

    @Override
    public void answered(Record body) {
        switch (body) {
            case Fiducial.Geometry geometry -> baseFromFinder = geometry.pose().to2d();
            case Fiducial.View view -> {
                fieldOfView = view.angle();
                rangeMax = view.maxRange();
            }
            default -> {}
        }
    }

    @Override
    Optional<Fiducials> read(Record body) {
        if (!(body instanceof Fiducial.Markers(List<Fiducial.Marker> markers))) {
            return Optional.empty();
        }
        List<Fiducials.Fiducial> seen = markers.stream()
                .map(marker -> new Fiducials.Fiducial(
                        marker.id() > 0 ? OptionalInt.of(marker.id()) : OptionalInt.empty(),
                        baseFromFinder.compose(marker.pose().to2d())))
                .sorted(Comparator.comparingDouble(
                        one -> one.baseFromFiducial().position().distanceTo(baseFromFinder.position())))
                .toList();
        return Optional.of(new Fiducials(baseFromFinder, fieldOfView, rangeMax, seen));
    }
}
