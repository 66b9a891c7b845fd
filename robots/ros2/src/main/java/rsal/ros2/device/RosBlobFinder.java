package rsal.ros2.device;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import rsal.data.Blobs;
import rsal.data.Blobs.Blob;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Rgb;
import rsal.device.BlobFinder;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.image.CameraMount;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;

/// A detector that publishes `vision_msgs/Detection2DArray`. Classes of what it detects are colors, `#2ca02c`; others
/// are left out. How large its images are, and how wide it looks, is what the model says, as the messages do not. A
/// detection with a place in space has its range and bearing by that, others their bearing by their box.
final class RosBlobFinder extends RosSensor<Blobs> implements BlobFinder {
    private static final int MOST_BLOBS = 1_000; // of an image

    private final Part.BlobFinder part;
    private final Frames frames;
    private final RobotClock clock;

    RosBlobFinder(DeviceInfo info, String topic, Part.BlobFinder part, Frames frames, RobotClock clock) {
        super(info, info.id(), topic);
        this.part = part;
        this.frames = frames;
        this.clock = clock;
    }

    void take(RosMessage message) {
        RosMessage header = message.message("header");
        String frame = header.text("frame_id");
        FrameTransform usual = CameraMount.of(part.baseFromCamera(), frame).baseFromFrame();
        mount(frames, frame, RosMessages.stamp(header), usual)
                .ifPresent(baseFromFrame -> take(message, new CameraMount(baseFromFrame)));
    }

    private void take(RosMessage message, CameraMount mount) {
        Pose2d baseFromCamera = mount.baseFromCamera();
        var empty = new Blobs(baseFromCamera, part.width(), part.height(), part.fieldOfView(), List.of());
        var blobs = new ArrayList<Blob>();
        for (RosMessage detection : message.messages("detections")) {
            if (blobs.size() < MOST_BLOBS) {
                blob(detection, mount, empty).ifPresent(blobs::add);
            }
        }
        blobs.sort(Comparator.comparingInt(Blob::left));
        heard(frames.now());
        publish(
                clock.time(RosMessages.stamp(message.message("header"))),
                new Blobs(baseFromCamera, part.width(), part.height(), part.fieldOfView(), blobs));
    }

    /// Empty when it is nothing that is looked for, or not in the image.
    ///
    /// @param image without blobs
    private Optional<Blob> blob(RosMessage detection, CameraMount mount, Blobs image) {
        List<RosMessage> results = detection.messages("results");
        if (results.isEmpty()) {
            return Optional.empty();
        }
        RosMessage hypothesis = results.getFirst().message("hypothesis");
        Optional<Rgb> color = Rgb.parse(hypothesis.text("class_id"))
                .filter(each -> part.colors().isEmpty() || part.colors().contains(each));
        RosMessage box = detection.message("bbox");
        RosMessage center = box.message("center").message("position");
        double x = center.number("x");
        double y = center.number("y");
        int left = edge(x - box.number("size_x") / 2, part.width());
        int right = edge(x + box.number("size_x") / 2, part.width());
        int top = edge(y - box.number("size_y") / 2, part.height());
        int bottom = edge(y + box.number("size_y") / 2, part.height());
        if (color.isEmpty() || left >= right || top >= bottom) {
            return Optional.empty();
        }
        Optional<Point2d> place = place(results.getFirst().message("pose").message("pose"), mount);
        double range = place.map(image.baseFromCamera().position()::distanceTo).orElse(Double.NaN);
        double column =
                place.map(image.baseFromCamera()::bearingTo).map(image::column).orElse(x);
        double share = hypothesis.number("score");
        int pixels = (right - left) * (bottom - top);
        int area = share > 0 && share < 1 ? Math.max(1, (int) Math.round(share * pixels)) : pixels;
        return Optional.of(new Blob(
                color.get(),
                left,
                top,
                right,
                bottom,
                Math.clamp(column, left, right),
                Math.clamp(y, top, bottom),
                area,
                range));
    }

    /// Of a box, in the image; 0 where it is not a number.
    private static int edge(double at, int size) {
        return (int) Math.round(Math.clamp(Double.isNaN(at) ? 0 : at, 0, size));
    }

    /// Seen from above; the origin stands for none.
    private static Optional<Point2d> place(RosMessage pose, CameraMount mount) {
        RosMessage position = pose.message("position");
        double x = position.number("x");
        double y = position.number("y");
        double z = position.number("z");
        boolean isReported = Double.isFinite(x + y + z) && (x != 0 || y != 0 || z != 0);
        return isReported ? Optional.of(mount.baseFromPoint(x, y, z)) : Optional.empty();
    }
}
