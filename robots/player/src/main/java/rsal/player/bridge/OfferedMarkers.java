package rsal.player.bridge;

import rsal.data.Fiducials;
import rsal.data.Stamped;
import rsal.device.FiducialFinder;
import rsal.player.message.Box2;
import rsal.player.message.Fiducial;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.wire.MessageKind;
import rsal.time.Scheduler;

/// A finder of markers as `fiducial`. Player's are seen from the finder, ours from the robot's base.
final class OfferedMarkers extends OfferedSensor<Fiducials> {
    private static final int UNREADABLE = -1;

    OfferedMarkers(int index, FiducialFinder finder, Scheduler scheduler) {
        super(Interface.FIDUCIAL, index, finder, scheduler);
    }

    @Override
    void publish(Stamped<Fiducials> reading) {
        Fiducials seen = reading.value();
        publish(
                Fiducial.SCAN,
                reading.time(),
                new Fiducial.Markers(
                        seen.fiducials().stream().map(one -> marker(seen, one)).toList()));
    }

    private static Fiducial.Marker marker(Fiducials seen, Fiducials.Fiducial one) {
        var finderFromMarker = seen.baseFromFinder().inverse().compose(one.baseFromFiducial());
        return new Fiducial.Marker(
                one.id().orElse(UNREADABLE), Pose3.of(finderFromMarker), new Pose3(0, 0, 0, 0, 0, 0));
    }

    @Override
    public boolean understands(MessageKind kind, int subtype) {
        return kind == MessageKind.REQUEST && (subtype == Fiducial.GEOMETRY || subtype == Fiducial.VIEW);
    }

    @Override
    Record body(Fiducials newest, int subtype) {
        return subtype == Fiducial.GEOMETRY
                ? new Fiducial.Geometry(Pose3.of(newest.baseFromFinder()), NO_SIZE, new Box2(0, 0))
                : new Fiducial.View(0, (float) newest.rangeMax(), (float) newest.fieldOfView());
    }
}
