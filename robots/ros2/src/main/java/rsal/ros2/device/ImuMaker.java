package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.imu.Imu;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes an IMU of the topic `imu`, of one with the device's name, or of the first one of its type.
final class ImuMaker implements RosParts.Maker {
    private static final String IMU = "sensor_msgs/msg/Imu";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Registered registered && registered.makes().equals(Imu.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("imu", "gyro");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return !topics.published(IMU, "imu").isEmpty();
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RosTopic topic = context.topics().named(IMU, info.name(), "imu");
        var imu = new RosImu(
                info,
                topic.name(),
                ((Part.Registered) wanted.part()).baseFromDevice(),
                context.frames(),
                context.clock());
        return RosDevice.of(imu, context.newest(topic, imu::take));
    }
}
