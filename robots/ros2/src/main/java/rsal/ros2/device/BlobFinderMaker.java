package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes a blob detector of the topic `camera/detections`, of one with the device's name, or of the first one of its
/// type.
final class BlobFinderMaker implements RosParts.Maker {
    private static final String DETECTIONS = "vision_msgs/msg/Detection2DArray";
    private static final String USUAL = "camera/detections";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.BlobFinder;
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("detector", "detections");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return !topics.published(DETECTIONS, USUAL).isEmpty();
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RosTopic topic = context.topics().named(DETECTIONS, info.name() + "/detections", USUAL);
        var finder = new RosBlobFinder(
                info, topic.name(), (Part.BlobFinder) wanted.part(), context.frames(), context.clock());
        return RosDevice.of(finder, context.newest(topic, finder::take));
    }
}
