package rsal.ros2.device;

import rsal.device.DeviceInfo;
import rsal.device.Mapper;
import rsal.robot.RobotModel.Part;
import rsal.ros2.device.RosParts.Wanted;
import rsal.ros2.health.ReportNames;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.CellMeaning;
import rsal.ros2.setting.RosSettings;

/// Makes a map of the robot's topic `map`, or of that of all robots, with its updates.
final class MapMaker implements RosParts.Maker {
    private static final String MAP = "nav_msgs/msg/OccupancyGrid";

    @Override
    public boolean makes(Part part) {
        return RosParts.isOwn(part, Mapper.class);
    }

    @Override
    public ReportNames reportNames() {
        return ReportNames.of("mapping").needing("map_server", "slam_toolbox");
    }

    /// It may be published later.
    @Override
    public boolean isThere(Wanted wanted, RobotTopics topics, RosSettings settings) {
        return true;
    }

    @Override
    public RosDevice make(DeviceInfo info, Wanted wanted, RosContext context) {
        RosTopic topic = context.topics().ownOrShared("map", MAP);
        var map = new PublicMap(info, topic.name(), context.clock());
        var grid = new PublicGrid(topic, CellMeaning.OCCUPANCY, context, map::take);
        return new RosDevice(
                map,
                now -> {
                    grid.look();
                    map.look(now, grid.publishers());
                },
                grid::close);
    }
}
