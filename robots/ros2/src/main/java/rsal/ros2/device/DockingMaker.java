package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.Docking;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.setting.RosSettings;

/// Makes docking of Nav2's actions `dock_robot` and `undock_robot`, which Jazzy and later distributions have.
final class DockingMaker implements RosParts.Maker {
    private static final String NAME = "dock_robot";

    @Override
    public boolean makes(Part part) {
        return RosParts.isOwn(part, Docking.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("docking").needing("docking_server");
    }

    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return topics.serves(NAME, RosDocking.DOCK);
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        String namespace = context.topics().namespace();
        var docking = new RosDocking(info, namespace + "/" + NAME, namespace + "/undock_robot", context);
        return new RosDevice(docking, docking::look, docking::end);
    }
}
