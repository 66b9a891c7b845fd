package rsal.testkit.fake;

import java.time.InstantSource;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.OptionalInt;
import org.jspecify.annotations.Nullable;
import rsal.data.Fiducials;
import rsal.data.Fiducials.Fiducial;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.FiducialFinder;
import rsal.device.SimulationControl.Marker;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// Finds markers exactly, or what a test shows it.
public final class FakeFiducialFinder extends FakeSensor<Fiducials> implements FiducialFinder {
    private final Part.FiducialFinder part;
    private final FakeDriveBase base;
    private final FakeWorld world;
    private final InstantSource clock;
    private @Nullable List<Fiducial> shown;

    FakeFiducialFinder(
            DeviceInfo info, Part.FiducialFinder part, FakeDriveBase base, FakeWorld world, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.world = world;
        this.clock = clock;
    }

    /// From now on every reading holds these markers.
    public void show(Fiducial... fiducials) {
        shown = List.of(fiducials);
    }

    @Override
    void sense() {
        Pose2d mapFromFinder = base.mapFromBase().compose(part.baseFromFinder());
        List<Fiducial> fiducials = shown != null
                ? shown
                : world.things().stream()
                        .sorted(Comparator.comparingDouble(t -> mapFromFinder.distanceTo(t.mapFromThing())))
                        .flatMap(thing -> look(thing, mapFromFinder).stream())
                        .toList();
        deliver(new Stamped<>(
                clock.instant(),
                info().robot() + "/base_link",
                new Fiducials(part.baseFromFinder(), part.fieldOfView(), part.rangeMax(), fiducials)));
    }

    private Optional<Fiducial> look(Thing thing, Pose2d mapFromFinder) {
        Optional<Marker> marker = thing.marker().filter(m -> m.key() == part.key());
        Pose2d mapFromThing = thing.mapFromThing();
        double distance = mapFromFinder.distanceTo(mapFromThing);
        if (marker.isEmpty()
                || distance > part.rangeMax()
                || Math.abs(mapFromFinder.bearingTo(mapFromThing.position())) > part.fieldOfView() / 2
                || !world.sees(mapFromFinder, mapFromThing.position())) {
            return Optional.empty();
        }
        OptionalInt id =
                distance <= part.idRange() ? OptionalInt.of(marker.get().id()) : OptionalInt.empty();
        return Optional.of(new Fiducial(id, base.mapFromBase().inverse().compose(mapFromThing)));
    }
}
