package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.ScanMessage;
import rsal.ros2.setting.RosSettings;

/// Makes lasers: the first one of `scan`, the others of the other topics of its type, by their names.
final class LaserMaker implements RosParts.Maker {
    private static final String SCAN = "sensor_msgs/msg/LaserScan";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Laser;
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("laser", "lidar", "scan", "scanner");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return topics.published(SCAN, "scan").size() > wanted.number();
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RosTopic topic = context.topics().published(SCAN, "scan").get(wanted.number());
        var laser = new RosLaser(info, topic.name(), (Part.Laser) wanted.part(), context.frames(), context.clock());
        String likely = topic.name().substring(1); // the frame
        return RosDevice.of(
                laser,
                context.link()
                        .subscribe(
                                topic,
                                Profile.SENSOR_DATA,
                                new Inbox<>(
                                        1,
                                        bytes -> ScanMessage.read(bytes, likely),
                                        context.scheduler(),
                                        laser::take)));
    }
}
