package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.Navigator;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;

/// Makes a navigator of the action `navigate_to_pose`.
final class NavigatorMaker implements RosParts.Maker {
    private static final String NAVIGATE = "nav2_msgs/action/NavigateToPose";

    @Override
    public boolean makes(Part part) {
        return part instanceof Part.Own own && own.makes().equals(Navigator.class);
    }

    /// It may be served later.
    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return true;
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        String name = context.topics().namespace() + "/navigate_to_pose";
        var navigator = new RosNavigator(info, context.action(name, NAVIGATE), name, context.base(), context.frames());
        return new RosDevice(navigator, navigator::look, navigator::end);
    }
}
