package rsal.server.description;

import java.util.List;
import java.util.Optional;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.engine.report.Reading;
import rsal.server.message.Messages.BlobInfo;
import rsal.server.message.Messages.CameraView;
import rsal.server.message.Messages.Cameras;

/// What cameras make out, to be drawn where they look.
public final class CameraViews {
    private static final int MOST = 100; // blobs of one camera

    private CameraViews() {}

    public static Cameras of(List<Reading> readings) {
        return new Cameras(readings.stream()
                .filter(reading -> reading.value().value() instanceof Blobs)
                .map(reading -> view(reading.device(), (Blobs) reading.value().value()))
                .toList());
    }

    private static CameraView view(String camera, Blobs seen) {
        return new CameraView(
                camera,
                seen.baseFromCamera().x(),
                seen.baseFromCamera().y(),
                seen.baseFromCamera().theta(),
                seen.fieldOfView(),
                seen.blobs().stream().limit(MOST).map(blob -> blob(seen, blob)).toList());
    }

    private static BlobInfo blob(Blobs seen, Blob blob) {
        return new BlobInfo(
                blob.color().toString(),
                seen.bearing(blob.right()),
                seen.bearing(blob.left()),
                Double.isFinite(blob.range()) ? Optional.of(blob.range()) : Optional.empty());
    }
}
