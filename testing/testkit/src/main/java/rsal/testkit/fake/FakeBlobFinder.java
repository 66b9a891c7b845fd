package rsal.testkit.fake;

import java.time.InstantSource;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.device.BlobFinder;
import rsal.device.DeviceInfo;
import rsal.device.SimulationControl.Thing;
import rsal.robot.RobotModel.Part;

/// A camera that sees each thing as a blob, or what a test shows it.
public final class FakeBlobFinder extends FakeSensor<Blobs> implements BlobFinder {
    private final Part.BlobFinder part;
    private final FakeDriveBase base;
    private final FakeWorld world;
    private final InstantSource clock;
    private @Nullable List<Blob> shown;

    FakeBlobFinder(DeviceInfo info, Part.BlobFinder part, FakeDriveBase base, FakeWorld world, InstantSource clock) {
        super(info);
        this.part = part;
        this.base = base;
        this.world = world;
        this.clock = clock;
    }

    /// From now on every image holds these blobs.
    public void show(Blob... blobs) {
        shown = List.of(blobs);
    }

    @Override
    void sense() {
        List<Blob> blobs = shown != null
                ? shown
                : world.things().stream()
                        .flatMap(thing -> look(thing).stream())
                        .sorted(Comparator.comparingDouble(Blob::x))
                        .toList();
        deliver(new Stamped<>(clock.instant(), info().id(), image(blobs)));
    }

    private Blobs image(List<Blob> blobs) {
        return new Blobs(part.baseFromCamera(), part.width(), part.height(), part.fieldOfView(), blobs);
    }

    private Optional<Blob> look(Thing thing) {
        Pose2d mapFromCamera = base.mapFromBase().compose(part.baseFromCamera());
        Rgb color = thing.color();
        double distance = mapFromCamera.distanceTo(thing.mapFromThing());
        double radius = Math.min(FakeWorld.radius(thing), distance);
        if (distance - radius > part.rangeMax()
                || !(part.colors().isEmpty() || part.colors().contains(color))
                || !world.sees(mapFromCamera, thing.mapFromThing().position())) {
            return Optional.empty();
        }
        Blobs image = image(List.of());
        double bearing = mapFromCamera.bearingTo(thing.mapFromThing().position());
        double half = Math.asin(radius / distance);
        int left = Math.clamp((int) Math.floor(image.column(bearing + half)), 0, part.width());
        int right = Math.clamp((int) Math.ceil(image.column(bearing - half)), 0, part.width());
        if (left >= right) {
            return Optional.empty();
        }
        double rows = thing.body().top() / distance / (part.fieldOfView() / part.width());
        int top = Math.clamp((int) Math.floor((part.height() - rows) / 2), 0, part.height() - 1);
        int bottom = Math.clamp((int) Math.ceil((part.height() + rows) / 2), top + 1, part.height());
        return Optional.of(new Blob(
                color,
                left,
                top,
                right,
                bottom,
                (left + right) / 2.0,
                (top + bottom) / 2.0,
                (right - left) * (bottom - top),
                distance - radius));
    }
}
