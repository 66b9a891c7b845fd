package rsal.player.bridge;

import java.util.Collections;
import java.util.List;
import rsal.data.RangeArray;
import rsal.data.Stamped;
import rsal.device.SonarArray;
import rsal.player.message.Box3;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.message.Ranger;
import rsal.player.message.Sonar;
import rsal.player.wire.MessageKind;
import rsal.time.Scheduler;

/// Sonars as `sonar`, or as `ranger`.
final class OfferedSonars extends OfferedSensor<RangeArray> {
    private static final Box3 SIZE = new Box3(0.15, 0.15, 0.2); // as Stage has them; no model of ours tells
    private static final Box3 SIZE_OF_ONE = new Box3(0.01, 0.05, 0.01);

    /// @param as `sonar` or `ranger`
    OfferedSonars(Interface as, int index, SonarArray sonars, Scheduler scheduler) {
        super(as, index, sonars, scheduler);
    }

    @Override
    void publish(Stamped<RangeArray> reading) {
        RangeArray round = reading.value();
        if (interf() == Interface.RANGER) {
            publish(
                    Ranger.RANGES,
                    reading.time(),
                    new Ranger.Ranges(Measured.doubles(round.ranges(), round.rangeMax())));
        } else {
            publish(Sonar.RANGES, reading.time(), new Sonar.Ranges(Measured.floats(round.ranges(), round.rangeMax())));
        }
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST
                && (interf() == Interface.RANGER
                        ? subtype == Ranger.GEOMETRY || subtype == Ranger.CONFIGURATION
                        : subtype == Sonar.GEOMETRY);
    }

    @Override
    Record body(RangeArray round, int subtype) {
        List<Pose3> poses = round.baseFromSensors().stream().map(Pose3::of).toList();
        if (interf() == Interface.SONAR) {
            return new Sonar.Geometry(poses);
        }
        if (subtype == Ranger.GEOMETRY) {
            return new Ranger.Geometry(
                    new Pose3(0, 0, 0, 0, 0, 0), SIZE, poses, Collections.nCopies(poses.size(), SIZE_OF_ONE));
        }
        return new Ranger.Configuration(
                -round.fieldOfView() / 2,
                round.fieldOfView() / 2,
                round.fieldOfView(),
                round.rangeMin(),
                round.rangeMax(),
                0,
                0);
    }
}
