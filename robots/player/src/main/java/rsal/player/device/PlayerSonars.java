package rsal.player.device;

import java.util.List;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.data.RangeArray;
import rsal.device.DeviceInfo;
import rsal.device.SonarArray;
import rsal.player.message.Pose3;
import rsal.player.message.Ranger;
import rsal.player.message.Sonar;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Part;

/// Sonars behind `ranger` or `sonar`. Where they are is what the server says; of what that does not say, what the
/// robot's model says.
final class PlayerSonars extends PlayerSensor<RangeArray> implements SonarArray {
    private List<Pose2d> baseFromSensors;
    private double fieldOfView;
    private double rangeMin;
    private double rangeMax;

    PlayerSonars(DeviceInfo info, Address address, Part.Sonars part) {
        super(info, address, info.robot() + "/base_link");
        this.baseFromSensors = part.baseFromSensors();
        this.fieldOfView = part.fieldOfView();
        this.rangeMin = part.rangeMin();
        this.rangeMax = part.rangeMax();
    }

    @Override
    public List<Integer> questions() {
        return Ranges.questions(address(), Sonar.GEOMETRY);
    }

    @Override
    public void answered(Record body) {
        switch (body) {
            case Ranger.Geometry geometry -> baseFromSensors = Ranges.places(geometry);
            case Sonar.Geometry geometry ->
                baseFromSensors = geometry.poses().stream().map(Pose3::to2d).toList();
            case Ranger.Configuration configuration -> {
                if (Ranges.isKnown(configuration)) {
                    fieldOfView = configuration.maxAngle() - configuration.minAngle();
                    rangeMin = configuration.minRange();
                    rangeMax = configuration.maxRange();
                }
            }
            default -> {}
        }
    }

    @Override
    Optional<RangeArray> read(Record body) {
        return switch (body) {
            case Ranger.Ranges(double[] ranges) -> round(Ranges.of(ranges, rangeMin, rangeMax));
            case Ranger.RangesStamped stamped ->
                round(Ranges.of(stamped.ranges().ranges(), rangeMin, rangeMax));
            case Sonar.Ranges(float[] ranges) -> round(Ranges.of(ranges, rangeMin, rangeMax));
            default -> Optional.empty();
        };
    }

    /// Nothing when there are more ranges or less than there are sonars: nobody knows then which is which.
    private Optional<RangeArray> round(float[] ranges) {
        return ranges.length == baseFromSensors.size()
                ? Optional.of(new RangeArray(baseFromSensors, fieldOfView, rangeMin, rangeMax, ranges))
                : Optional.empty();
    }
}
