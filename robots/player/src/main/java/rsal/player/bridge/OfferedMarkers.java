package rsal.player.bridge;

import java.util.Optional;
import rsal.data.Fiducials;
import rsal.data.Stamped;
import rsal.device.FiducialFinder;
import rsal.device.Subscription;
import rsal.player.message.Box2;
import rsal.player.message.Fiducial;
import rsal.player.message.Interface;
import rsal.player.message.Pose3;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;
import rsal.time.Scheduler;

/// A finder of markers as `fiducial`. Player's are seen from the finder, ours from the robot's base.
final class OfferedMarkers extends Offered {
    private static final int UNREADABLE = -1;

    private final FiducialFinder finder;

    OfferedMarkers(int index, FiducialFinder finder, Scheduler scheduler) {
        super(Interface.FIDUCIAL, index, finder.info(), scheduler);
        this.finder = finder;
    }

    @Override
    Subscription listen() {
        return finder.subscribe(this::tell);
    }

    private void tell(Stamped<Fiducials> reading) {
        Fiducials seen = reading.value();
        publish(
                Fiducial.SCAN,
                reading.time(),
                new Fiducial.Markers(
                        seen.fiducials().stream().map(one -> marker(seen, one)).toList()));
    }

    private static Fiducial.Marker marker(Fiducials seen, Fiducials.Fiducial one) {
        var finderFromMarker = seen.baseFromFinder().inverse().compose(one.baseFromFiducial());
        return new Fiducial.Marker(one.id().orElse(UNREADABLE), pose3(finderFromMarker), new Pose3(0, 0, 0, 0, 0, 0));
    }

    @Override
    public boolean understands(Kind kind, int subtype) {
        return kind == Kind.REQUEST && (subtype == Fiducial.GEOMETRY || subtype == Fiducial.VIEW);
    }

    @Override
    Optional<Answer> answer(Packet request) {
        int subtype = request.header().subtype();
        return finder.latest()
                .map(Stamped::value)
                .filter(_ -> understands(Kind.REQUEST, subtype))
                .map(seen -> new Answer.Told(
                        subtype == Fiducial.GEOMETRY
                                ? new Fiducial.Geometry(pose3(seen.baseFromFinder()), NO_SIZE, new Box2(0, 0))
                                : new Fiducial.View(0, (float) seen.rangeMax(), (float) seen.fieldOfView())));
    }
}
