package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes a battery of `battery_state`, or of the first topic of its type.
final class BatteryMaker implements RosParts.Maker {
    private static final String BATTERY = "sensor_msgs/msg/BatteryState";
    private static final String USUAL = "battery_state";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Battery;
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("battery", "bms");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return !topics.published(BATTERY, USUAL).isEmpty();
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RosTopic topic = context.topics().published(BATTERY, USUAL).getFirst();
        var battery = new RosBattery(info, topic.name(), context.frames(), context.clock());
        return RosDevice.of(battery, context.newest(topic, battery::take));
    }
}
