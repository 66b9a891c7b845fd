package rsal.ros2.device;

import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.Optional;
import rsal.device.DeviceInfo;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.RosMessages;

/// A camera that publishes `sensor_msgs/Image`, in color and, if it can, as depth. An image is one of color with the
/// one of depth that was taken with it, which may come some images later, as depth takes time to compute. Its focal
/// length is that of `sensor_msgs/CameraInfo`, or, as long as none has come, the model's.
final class RosCamera extends RosSensor<CameraImage> implements Camera {
    private static final long TOGETHER = 20_000_000; // ns, between color and depth of one image at most
    private static final int MOST_WAITING = 5; // images of color, and of depth

    private final double usualFocalLength; // px
    private final boolean hasDepth;
    private final Frames frames;
    private final RobotClock clock;
    private double focalLength; // px; 0 as long as nobody has told
    private int toldWidth; // px, of images of that focal length
    private final Deque<Taken> colors = new ArrayDeque<>(); // without depth yet
    private final Deque<Taken> depths = new ArrayDeque<>(); // without color yet

    /// @param stamp [ns]
    private record Taken(long stamp, ImageMessage image) {
        boolean isWith(Taken other) {
            return Math.abs(stamp - other.stamp) <= TOGETHER;
        }
    }

    /// @param topic of its images in color
    /// @param focalLength of the model [px]
    /// @param hasDepth whether images of depth are to come
    RosCamera(DeviceInfo info, String topic, double focalLength, boolean hasDepth, Frames frames, RobotClock clock) {
        super(info, info.id(), topic);
        this.usualFocalLength = focalLength;
        this.hasDepth = hasDepth;
        this.frames = frames;
        this.clock = clock;
    }

    void takeInfo(RosMessage message) {
        double focal = message.get("k", double[].class)[0];
        long width = message.integer("width");
        if (focal > 0 && Double.isFinite(focal) && width > 0 && width <= ImageMessage.LONGEST) {
            focalLength = focal;
            toldWidth = (int) width;
        }
    }

    void takeColor(RosMessage message) {
        taken(message).ifPresent(color -> {
            if (hasDepth) {
                keep(colors, color);
                find(depths, color).ifPresent(depth -> join(color, Optional.of(depth)));
            } else {
                join(color, Optional.empty());
            }
        });
    }

    void takeDepth(RosMessage message) {
        taken(message).ifPresent(depth -> {
            keep(depths, depth);
            find(colors, depth).ifPresent(color -> join(color, Optional.of(depth)));
        });
    }

    private static void keep(Deque<Taken> waiting, Taken image) {
        if (waiting.size() == MOST_WAITING) {
            waiting.removeFirst();
        }
        waiting.addLast(image);
    }

    private static Optional<Taken> find(Deque<Taken> waiting, Taken other) {
        return waiting.stream()
                .filter(other::isWith)
                .min(Comparator.comparingLong(each -> Math.abs(each.stamp - other.stamp)));
    }

    private static Optional<Taken> taken(RosMessage message) {
        long stamp = RosMessages.stamp(message.message("header"));
        return ImageMessage.of(message).map(image -> new Taken(stamp, image));
    }

    private void join(Taken color, Optional<Taken> depth) {
        colors.removeIf(each -> each.stamp <= color.stamp);
        depths.removeIf(each -> each.stamp <= color.stamp + TOGETHER);
        int width = color.image.width();
        int height = color.image.height();
        Optional<byte[]> rgb = color.image.rgb();
        if (rgb.isEmpty()) {
            return;
        }
        byte[] millimeters =
                depth.flatMap(taken -> taken.image.depth(width, height)).orElseGet(() -> new byte[2 * width * height]);
        double focal = focalLength > 0 ? focalLength * width / toldWidth : usualFocalLength;
        heard(frames.now());
        tell(clock.time(color.stamp), new CameraImage(width, height, focal, rgb.get(), millimeters));
    }
}
