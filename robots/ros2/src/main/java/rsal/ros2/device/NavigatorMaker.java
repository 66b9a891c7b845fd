package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.Navigator;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.CellMeaning;
import rsal.ros2.setting.RosSettings;

/// Makes a navigator of the action `navigate_to_pose`, with the costs of `global_costmap/costmap`.
final class NavigatorMaker implements RosParts.Maker {
    private static final String COSTS = "nav_msgs/msg/OccupancyGrid";
    private static final String NAVIGATE = "nav2_msgs/action/NavigateToPose";

    @Override
    public boolean makes(Part part) {
        return RosParts.isOwn(part, Navigator.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("navigation")
                .needing("bt_navigator")
                .needing("planner_server")
                .needing("controller_server");
    }

    /// It may be served later.
    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return true;
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        String name = context.topics().namespace() + "/navigate_to_pose";
        var costs = new RosTopic(context.topics().namespace() + "/global_costmap/costmap", COSTS);
        var navigator = new RosNavigator(
                info,
                context.action(name, NAVIGATE),
                name,
                context.base(),
                context.frames(),
                () -> new PublicGrid(costs, CellMeaning.COSTS, context, (_, _) -> {}));
        return new RosDevice(navigator, navigator::look, navigator::end);
    }
}
