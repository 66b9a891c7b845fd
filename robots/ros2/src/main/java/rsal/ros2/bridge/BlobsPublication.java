package rsal.ros2.bridge;

import java.time.Instant;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Stamped;
import rsal.device.BlobFinder;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.message.RosMessages;

/// Patches of color as `vision_msgs/Detection2DArray`, in the optical frame of their camera: the color is the class,
/// `#2ca02c`; the score is the share of the box that the patch fills; the place has the bearing and the range at the
/// camera's height, or is the origin where the range is unknown.
final class BlobsPublication {
    private static final int COVARIANCES = 36;

    private final CdrWriter writer = new CdrWriter();
    private final RobotOutlet outlet;

    private BlobsPublication(RobotOutlet outlet) {
        this.outlet = outlet;
    }

    static void begin(BlobFinder finder, RobotOutlet outlet) {
        var publication = new BlobsPublication(outlet);
        String name = finder.info().name();
        String frame = outlet.frames().optical(name);
        Publication detections =
                outlet.advertise(finder, name + "/detections", "vision_msgs/msg/Detection2DArray", Profile.DEFAULT);
        outlet.keep(finder.subscribe(reading -> {
            if (outlet.mountCamera(reading.time(), name, reading.value().baseFromCamera())) {
                outlet.publishMounts(reading.time());
            }
            detections.publish(publication.message(reading, frame));
        }));
    }

    private byte[] message(Stamped<Blobs> reading, String frame) {
        Blobs blobs = reading.value();
        Instant time = outlet.stamp(reading.time());
        RosMessages.write(writer.clear(), time).text(frame);
        writer.int32(blobs.blobs().size());
        for (Blob blob : blobs.blobs()) {
            RosMessages.write(writer, time).text(frame);
            write(blobs, blob);
        }
        return writer.toBytes();
    }

    /// The rest of a `vision_msgs/Detection2D`.
    private void write(Blobs blobs, Blob blob) {
        int width = blob.right() - blob.left();
        int height = blob.bottom() - blob.top();
        writer.int32(1).text(blob.color().toString()).float64((double) blob.area() / (width * height));
        boolean isPlaced = Double.isFinite(blob.range());
        double bearing = blobs.bearing(blob);
        writer.float64(isPlaced ? -blob.range() * Math.sin(bearing) : 0);
        writer.float64(0);
        writer.float64(isPlaced ? blob.range() * Math.cos(bearing) : 0);
        writer.float64(0).float64(0).float64(0).float64(1);
        writer.float64s(new double[COVARIANCES]);
        writer.float64(blob.left() + width / 2.0).float64(blob.top() + height / 2.0);
        writer.float64(0).float64(width).float64(height);
        writer.text(""); // no id: patches are not tracked
    }
}
