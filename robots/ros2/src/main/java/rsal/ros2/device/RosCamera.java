package rsal.ros2.device;

import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.util.ArrayDeque;
import java.util.Comparator;
import java.util.Deque;
import java.util.Optional;
import rsal.device.DeviceInfo;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraImage;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.image.CompressedImage;
import rsal.ros2.image.ImageDecoder;
import rsal.ros2.image.ImageMessage;
import rsal.ros2.message.RosMessages;

/// A camera that publishes `sensor_msgs/Image` or `sensor_msgs/CompressedImage`, in color and, if it can, as depth. An
/// image is one of color with the one of depth that was taken with it, which may come some images later, as depth takes
/// time to compute. Its focal length is that of `sensor_msgs/CameraInfo`, or, as long as none has come, the model's.
final class RosCamera extends RosSensor<CameraImage> implements Camera {
    private static final Logger LOG = System.getLogger(RosCamera.class.getName());
    private static final long TOGETHER = 20_000_000; // ns, between color and depth of one image at most
    private static final int LONGEST_ENCODING = 40; // characters that are shown
    private static final int MOST_WAITING = 5; // images of color, and of depth

    private final String topic;
    private final double usualFocalLength; // px
    private final boolean hasDepth;
    private final ImageDecoder decoder;
    private final ImageDecoder depthDecoder;
    private final Frames frames;
    private final RobotClock clock;
    private double focalLength; // px; 0 as long as nobody has told
    private long damaged; // images
    private int reportedWidth; // px, of images of that focal length
    private final Deque<Taken> colors = new ArrayDeque<>(); // without depth yet
    private final Deque<Taken> depths = new ArrayDeque<>(); // without color yet
    private final Deque<Compressed> compressedDepths = new ArrayDeque<>(); // also

    /// @param stamp [ns]
    private record Taken(long stamp, ImageMessage image) {
        boolean isWith(Taken other) {
            return Math.abs(stamp - other.stamp) <= TOGETHER;
        }
    }

    /// Depth that is decoded only if there is an image in color with it.
    ///
    /// @param stamp [ns]
    private record Compressed(long stamp, byte[] data, String format) {
        boolean isWith(Taken color) {
            return Math.abs(stamp - color.stamp) <= TOGETHER;
        }
    }

    /// @param topic of its images in color
    /// @param focalLength of the model [px]
    /// @param hasDepth whether images of depth are to come
    RosCamera(
            DeviceInfo info,
            String topic,
            double focalLength,
            boolean hasDepth,
            ImageDecoder decoder,
            ImageDecoder depthDecoder,
            Frames frames,
            RobotClock clock) {
        super(info, info.id(), topic);
        this.topic = topic;
        this.usualFocalLength = focalLength;
        this.hasDepth = hasDepth;
        this.decoder = decoder;
        this.depthDecoder = depthDecoder;
        this.frames = frames;
        this.clock = clock;
    }

    void takeInfo(RosMessage message) {
        double focal = message.get("k", double[].class)[0];
        long width = message.integer("width");
        if (focal > 0 && Double.isFinite(focal) && width > 0 && width <= ImageMessage.LONGEST) {
            focalLength = focal;
            reportedWidth = (int) width;
        }
    }

    void takeColor(RosMessage message) {
        takeColor(taken(message));
    }

    /// @param message `sensor_msgs/CompressedImage`
    void takeCompressed(RosMessage message) {
        long stamp = RosMessages.stamp(message.message("header"));
        byte[] data = message.get("data", byte[].class);
        decoder.decode(
                () -> CompressedImage.read(data),
                image -> takeColor(Optional.of(new Taken(stamp, image))),
                this::damaged);
    }

    private void takeColor(Optional<Taken> taken) {
        taken.ifPresent(color -> {
            if (hasDepth) {
                keep(colors, color);
                find(depths, color).ifPresent(depth -> join(color, Optional.of(depth)));
                compressedDepths.stream()
                        .filter(depth -> depth.isWith(color))
                        .findFirst()
                        .ifPresent(depth -> decode(depth, color));
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

    /// @param message `sensor_msgs/CompressedImage` of `compressed_depth_image_transport`
    void takeCompressedDepth(RosMessage message) {
        var depth = new Compressed(
                RosMessages.stamp(message.message("header")),
                message.get("data", byte[].class),
                message.text("format"));
        keep(compressedDepths, depth);
        colors.stream().filter(depth::isWith).findFirst().ifPresent(color -> decode(depth, color));
    }

    private void decode(Compressed depth, Taken color) {
        depthDecoder.decode(
                () -> CompressedImage.readDepth(depth.data, depth.format),
                image -> join(color, Optional.of(new Taken(depth.stamp, image))),
                this::damaged);
    }

    private static <T> void keep(Deque<T> waiting, T image) {
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

    private Optional<Taken> taken(RosMessage message) {
        long stamp = RosMessages.stamp(message.message("header"));
        Optional<Taken> taken = ImageMessage.of(message).map(image -> new Taken(stamp, image));
        if (taken.isEmpty()) {
            damaged("%d × %d pixels in '%s' with %d bytes"
                    .formatted(
                            message.integer("width"),
                            message.integer("height"),
                            shortened(message.text("encoding")),
                            message.get("data", byte[].class).length));
        }
        return taken;
    }

    private static String shortened(String encoding) {
        return encoding.substring(0, Math.min(encoding.length(), LONGEST_ENCODING));
    }

    /// The first one is told, and at the end how many there were.
    private void damaged(String why) {
        if (damaged++ == 0) {
            LOG.log(
                    Level.WARNING,
                    () -> "An image on '%s' can't be read: %s. It is ignored, as others like it."
                            .formatted(topic, why));
        }
    }

    /// For good.
    void end() {
        if (damaged > 0) {
            LOG.log(Level.INFO, () -> "%d images on '%s' could not be read.".formatted(damaged, topic));
        }
    }

    private void join(Taken color, Optional<Taken> depth) {
        colors.removeIf(each -> each.stamp <= color.stamp);
        depths.removeIf(each -> each.stamp <= color.stamp + TOGETHER);
        compressedDepths.removeIf(each -> each.stamp <= color.stamp + TOGETHER);
        int width = color.image.width();
        int height = color.image.height();
        Optional<byte[]> rgb = color.image.rgb();
        if (rgb.isEmpty()) {
            return;
        }
        byte[] millimeters =
                depth.flatMap(taken -> taken.image.depth(width, height)).orElseGet(() -> new byte[2 * width * height]);
        double focal = focalLength > 0 ? focalLength * width / reportedWidth : usualFocalLength;
        heard(frames.now());
        publish(clock.time(color.stamp), new CameraImage(width, height, focal, rgb.get(), millimeters));
    }
}
