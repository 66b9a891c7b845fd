package rsal.ros2.device;

import java.util.List;
import java.util.Locale;
import java.util.Optional;
import rsal.device.DeviceInfo;
import rsal.device.camera.Camera;
import rsal.device.camera.CameraKind;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.image.ImageDecoder;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes a camera of its images: `camera/image_raw`, those below the device's name, or the first ones; with depth
/// if there is a topic with `depth` in its name. Where colors are compressed only, it is made of `…/compressed`,
/// and where depth is, of `…/compressedDepth`.
final class CameraMaker implements RosParts.Maker {
    private static final String IMAGE = "sensor_msgs/msg/Image";
    private static final String COMPRESSED_IMAGE = "sensor_msgs/msg/CompressedImage";
    private static final String COMPRESSED = "/compressed"; // behind the name of the topic of plain images
    private static final String COMPRESSED_DEPTH = "/compressedDepth"; // also
    private static final String INFO = "sensor_msgs/msg/CameraInfo";
    private static final String DEPTH = "depth";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Registered registered && registered.makes().equals(Camera.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("camera");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return colors(wanted.name(), topics).isPresent();
    }

    @Override
    public boolean isComplete(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return images(wanted.name(), topics, false).isPresent()
                && images(wanted.name(), topics, true).isPresent();
    }

    /// @param name the device's
    private static Optional<RosTopic> colors(String name, RobotTopics topics) {
        return images(name, topics, false)
                .or(() -> images(name, topics, new RosTopic("/image_raw" + COMPRESSED, COMPRESSED_IMAGE), false));
    }

    private static Optional<RosTopic> depths(String name, RobotTopics topics) {
        var usual = new RosTopic("/depth/image_raw" + COMPRESSED_DEPTH, COMPRESSED_IMAGE);
        return images(name, topics, true).or(() -> images(name, topics, usual, true));
    }

    private static Optional<RosTopic> images(String name, RobotTopics topics, boolean hasDepth) {
        return images(name, topics, new RosTopic(hasDepth ? "/depth/image_raw" : "/image_raw", IMAGE), hasDepth);
    }

    /// @param usual below the name of the device or `camera`
    private static Optional<RosTopic> images(String name, RobotTopics topics, RosTopic usual, boolean hasDepth) {
        var named = new RosTopic(topics.namespace() + "/" + name + usual.name(), usual.type());
        List<RosTopic> all = topics.published(usual.type(), "camera" + usual.name());
        return all.contains(named)
                ? Optional.of(named)
                : all.stream()
                        .filter(topic -> isOfDepth(topic, topics) == hasDepth)
                        .filter(topic ->
                                topic.type().equals(IMAGE) || topic.name().endsWith(COMPRESSED_DEPTH) == hasDepth)
                        .findFirst();
    }

    /// By its name. Programs offer all images as compressed depth, too.
    private static boolean isOfDepth(RosTopic topic, RobotTopics topics) {
        String plain = topic.name().endsWith(COMPRESSED_DEPTH)
                ? topic.name().substring(0, topic.name().length() - COMPRESSED_DEPTH.length())
                : topic.name();
        return plain.substring(topics.namespace().length())
                .toLowerCase(Locale.ROOT)
                .contains(DEPTH);
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RosTopic color = colors(info.name(), context.topics()).orElseThrow();
        Optional<RosTopic> depth = depths(info.name(), context.topics());
        double focal = CameraKind.focalLength(((Part.Registered) wanted.part()).arguments());
        var camera = new RosCamera(
                info,
                color.name(),
                focal,
                depth.isPresent(),
                ImageDecoder.ofTenASecond(context.scheduler()),
                ImageDecoder.ofAll(context.scheduler()), // those that have an image in color
                context.frames(),
                context.clock());
        boolean isCompressed = color.type().equals(COMPRESSED_IMAGE);
        Subscribed images = context.newest(color, isCompressed ? camera::takeCompressed : camera::takeColor);
        Optional<Subscribed> depths = depth.map(topic ->
                context.newest(topic, topic.type().equals(IMAGE) ? camera::takeDepth : camera::takeCompressedDepth));
        String plain = isCompressed && color.name().endsWith(COMPRESSED)
                ? color.name().substring(0, color.name().length() - COMPRESSED.length())
                : color.name();
        String folder = plain.substring(0, plain.lastIndexOf('/') + 1);
        Subscribed infos = context.newest(new RosTopic(folder + "camera_info", INFO), camera::takeInfo);
        return new RosDevice(camera, now -> camera.look(now, images.publishers()), () -> {
            images.close();
            depths.ifPresent(Subscribed::close);
            infos.close();
            camera.end();
        });
    }
}
