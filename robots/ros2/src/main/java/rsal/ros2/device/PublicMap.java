package rsal.ros2.device;

import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.device.DeviceInfo;
import rsal.device.Mapper;

/// A map that somebody publishes: `map_server`, or slam_toolbox, which publishes it again and again. Its borders
/// are not known here, and it drives nothing.
final class PublicMap extends RosSensor<OccupancyGrid> implements Mapper {
    private final RobotClock clock;

    PublicMap(DeviceInfo info, String topic, RobotClock clock) {
        super(info, "map", topic);
        this.clock = clock;
    }

    /// @param stamp when it was drawn [ns]
    void take(OccupancyGrid map, long stamp) {
        publish(clock.time(stamp), map);
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
