package rsal.ros2.device;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.device.DeviceInfo;
import rsal.device.Mapper;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.MapMessage;
import rsal.ros2.message.RosMessages;

/// A map that somebody publishes as `nav_msgs/OccupancyGrid`: `map_server`, or slam_toolbox, which publishes it again
/// and again. Where it ends is not known here, and it drives nothing.
final class PublicMap extends RosSensor<OccupancyGrid> implements Mapper {
    private final RobotClock clock;

    PublicMap(DeviceInfo info, String topic, RobotClock clock) {
        super(info, "map", topic);
        this.clock = clock;
    }

    void take(RosMessage message) {
        MapMessage.of(message).ifPresent(map -> tell(clock.time(RosMessages.stamp(message.message("header"))), map));
    }

    @Override
    public boolean isComplete() {
        return true;
    }

    @Override
    public List<End> ends() {
        return List.of();
    }

    @Override
    public void leaveAlone(End end) {}

    @Override
    public void pause() {}

    @Override
    public void resume() {}

    /// The driving is always left to others.
    @Override
    public boolean paused() {
        return true;
    }
}
