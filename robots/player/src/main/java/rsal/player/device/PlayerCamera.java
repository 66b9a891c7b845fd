package rsal.player.device;

import java.util.Comparator;
import java.util.Optional;
import rsal.data.Blobs;
import rsal.data.Rgb;
import rsal.device.BlobFinder;
import rsal.device.DeviceInfo;
import rsal.player.message.Blobfinder;
import rsal.player.wire.Address;
import rsal.robot.RobotModel.Part;

/// A camera behind `blobfinder`, which tells nothing of how it is mounted and how wide its view is: that, and which
/// colors count, is what the robot's model says.
final class PlayerCamera extends PlayerSensor<Blobs> implements BlobFinder {
    private final Part.BlobFinder part;

    PlayerCamera(DeviceInfo info, Address address, Part.BlobFinder part) {
        super(info, address, info.id());
        this.part = part;
    }

    @Override
    Optional<Blobs> read(Record body) {
        if (!(body instanceof Blobfinder.Blobs image)) {
            return Optional.empty();
        }
        return Optional.of(new Blobs(
                part.baseFromCamera(),
                image.width() > 0 ? image.width() : part.width(),
                image.height() > 0 ? image.height() : part.height(),
                part.fieldOfView(),
                image.blobs().stream()
                        .map(PlayerCamera::blob)
                        .filter(blob -> part.colors().isEmpty() || part.colors().contains(blob.color()))
                        .sorted(Comparator.comparingInt(Blobs.Blob::left))
                        .toList()));
    }

    /// A pixel reaches from its number to the next.
    private static Blobs.Blob blob(Blobfinder.Blob blob) {
        return new Blobs.Blob(
                Rgb.of(blob.color()),
                blob.left(),
                blob.top(),
                blob.right(),
                blob.bottom(),
                blob.x() + 0.5,
                blob.y() + 0.5,
                blob.area(),
                blob.range() > 0 ? blob.range() : Double.NaN);
    }
}
