package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.setting.RosSettings;

/// Makes a planner of the action `compute_path_to_pose`.
final class PlannerMaker implements RosParts.Maker {
    private static final String NAME = "compute_path_to_pose";

    @Override
    public boolean makes(Part part) {
        return RosParts.isOwn(part, Planner.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("planning").needing("planner_server");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return topics.serves(NAME, RosPlanner.ACTION);
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        var planner = new RosPlanner(info, context.topics().namespace() + "/" + NAME, context);
        return new RosDevice(planner, planner::look, planner::end);
    }
}
