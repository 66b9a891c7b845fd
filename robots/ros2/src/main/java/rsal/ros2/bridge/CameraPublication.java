package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Stamped;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;

/// A camera with depth as `sensor_msgs/Image` in `rgb8` and `16UC1` (REP 118) with `sensor_msgs/CameraInfo`, in its
/// optical frame. Images are published while somebody subscribes to them, ten times a second at most.
final class CameraPublication {
    private static final Duration PERIOD = Duration.ofMillis(100);
    private static final Duration TOLERANCE = Duration.ofMillis(5); // of a camera of the same period
    private static final String IMAGE = "sensor_msgs/msg/Image";
    private static final String INFO = "sensor_msgs/msg/CameraInfo";
    private static final int COEFFICIENTS = 5; // of the distortion `plumb_bob`

    private final CdrWriter writer = new CdrWriter();
    private final RobotOutlet outlet;
    private final String name;
    private final Stream color;
    private final Stream depth;
    private Instant published = Instant.MIN;

    /// Images of one sort, with how they were taken.
    private record Stream(RosTopic topic, Publication images, RosTopic infoTopic, Publication infos) {}

    private CameraPublication(Camera camera, RobotOutlet outlet) {
        this.outlet = outlet;
        name = camera.info().name();
        color = stream(camera, name + "/");
        depth = stream(camera, name + "/depth/");
    }

    private Stream stream(Camera camera, String prefix) {
        String image = prefix + "image_raw";
        String info = prefix + "camera_info";
        return new Stream(
                outlet.topic(image, IMAGE),
                outlet.advertise(camera, image, IMAGE, Profile.DEFAULT),
                outlet.topic(info, INFO),
                outlet.advertise(camera, info, INFO, Profile.DEFAULT));
    }

    static void begin(Camera camera, RobotOutlet outlet) {
        outlet.keep(camera.subscribe(new CameraPublication(camera, outlet)::publish));
    }

    private void publish(Stamped<CameraImage> reading) {
        if (outlet.robot().model().sensors().get(name) instanceof Part.Registered part
                && outlet.mountCamera(reading.time(), name, part.baseFromDevice())) {
            outlet.publishMounts(reading.time());
        }
        if (published.plus(PERIOD).minus(TOLERANCE).isAfter(reading.time())) {
            return;
        }
        published = reading.time();
        CameraImage image = reading.value();
        publish(color, reading, "rgb8", 3, image.rgb());
        publish(depth, reading, "16UC1", 2, image.depth());
    }

    /// @param pixel its size [bytes]
    private void publish(Stream stream, Stamped<CameraImage> reading, String encoding, int pixel, byte[] data) {
        CameraImage image = reading.value();
        if (outlet.isHeard(stream.infoTopic)) {
            stream.infos.publish(info(reading.time(), image));
        }
        if (outlet.isHeard(stream.topic)) {
            RosMessages.write(writer.clear(), outlet.stamp(reading.time()))
                    .text(outlet.frames().optical(name))
                    .int32(image.height())
                    .int32(image.width())
                    .text(encoding)
                    .int8((byte) 0) // the lower byte first
                    .int32(pixel * image.width())
                    .int32(data.length)
                    .int8s(data);
            stream.images.publish(writer.toBytes());
        }
    }

    /// A pinhole without distortion, which looks through the middle of its image.
    private byte[] info(Instant time, CameraImage image) {
        double focal = image.focalLength();
        double x = image.width() / 2.0 - 0.5; // of the middle, as the middle of the first pixel is 0
        double y = image.height() / 2.0 - 0.5;
        RosMessages.write(writer.clear(), outlet.stamp(time))
                .text(outlet.frames().optical(name))
                .int32(image.height())
                .int32(image.width())
                .text("plumb_bob")
                .int32(COEFFICIENTS)
                .float64s(new double[COEFFICIENTS])
                .float64s(new double[] {focal, 0, x, 0, focal, y, 0, 0, 1})
                .float64s(new double[] {1, 0, 0, 0, 1, 0, 0, 0, 1})
                .float64s(new double[] {focal, 0, x, 0, 0, focal, y, 0, 0, 0, 1, 0})
                .int32(0) // no binning
                .int32(0);
        return writer.int32(0).int32(0).int32(0).int32(0).bool(false).toBytes(); // the whole image
    }
}
