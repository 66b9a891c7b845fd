package rsal.player.bridge;

import rsal.data.Blobs;
import rsal.data.Stamped;
import rsal.device.BlobFinder;
import rsal.player.message.Blobfinder;
import rsal.player.message.Interface;
import rsal.time.Scheduler;

/// A camera that finds patches of color as `blobfinder`.
final class OfferedCamera extends OfferedSensor<Blobs> {
    OfferedCamera(int index, BlobFinder camera, Scheduler scheduler) {
        super(Interface.BLOBFINDER, index, camera, scheduler);
    }

    @Override
    void publish(Stamped<Blobs> reading) {
        Blobs image = reading.value();
        publish(
                Blobfinder.BLOBS,
                reading.time(),
                new Blobfinder.Blobs(
                        image.width(),
                        image.height(),
                        image.blobs().stream().map(OfferedCamera::blob).toList()));
    }

    private static Blobfinder.Blob blob(Blobs.Blob blob) {
        return new Blobfinder.Blob(
                0,
                blob.color().packed(),
                blob.area(),
                (int) blob.x(),
                (int) blob.y(),
                blob.left(),
                blob.right(),
                blob.top(),
                blob.bottom(),
                Double.isFinite(blob.range()) ? (float) blob.range() : 0);
    }
}
