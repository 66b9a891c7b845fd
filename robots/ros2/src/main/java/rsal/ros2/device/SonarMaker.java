package rsal.ros2.device;

import java.util.ArrayList;
import java.util.List;
import rsal.device.DeviceInfo;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.setting.RosSettings;

/// Makes sonars of as many topics of their type, by their names.
final class SonarMaker implements RosParts.Maker {
    private static final String RANGE = "sensor_msgs/msg/Range";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Sonars;
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("sonar", "sonars", "ultrasonic");
    }

    private static int count(Wanted wanted) {
        return ((Part.Sonars) wanted.part()).baseFromSensors().size();
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return topics.published(RANGE, "").size() >= count(wanted);
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        List<RosTopic> all = context.topics().published(RANGE, "");
        var sonars = new RosSonars(
                info, all.getFirst().name(), (Part.Sonars) wanted.part(), context.frames(), context.clock());
        var subscriptions = new ArrayList<Subscribed>();
        for (int i = 0; i < count(wanted); i++) {
            int sensor = i;
            subscriptions.add(context.newest(all.get(i), message -> sonars.take(sensor, message)));
        }
        Subscribed first = subscriptions.getFirst();
        return new RosDevice(
                sonars, now -> sonars.look(now, first.publishers()), () -> subscriptions.forEach(Subscribed::close));
    }
}
