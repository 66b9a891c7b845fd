package rsal.agents;

import java.time.Instant;
import java.util.List;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.data.Stamped;
import rsal.device.BlobFinder;
import rsal.device.DeviceInfo;
import rsal.device.SensorCore;

/// A camera in the middle of a robot, 100 columns over 90°.
public final class FakeCamera extends SensorCore<Blobs> implements BlobFinder {
    public static final Rgb GREEN = Rgb.of(0x2ca02c);

    public FakeCamera(String robot) {
        super(new DeviceInfo(robot, "camera", "fake"));
    }

    /// Shows one patch straight ahead, ten columns wide.
    public void show(Rgb color, double range) {
        show(List.of(new Blob(color, 45, 30, 55, 40, 50, 35, 100, range)));
    }

    /// Shows one patch of which the left border of the image hides a part.
    public void showAtTheBorder(Rgb color, double range) {
        show(List.of(new Blob(color, 0, 30, 10, 40, 5, 35, 100, range)));
    }

    private void show(List<Blob> blobs) {
        var image = new Blobs(Pose2d.ORIGIN, 100, 80, Math.toRadians(90), blobs);
        deliver(new Stamped<>(Instant.EPOCH, info().id(), image));
    }
}
