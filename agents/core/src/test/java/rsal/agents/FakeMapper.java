package rsal.agents;

import rsal.data.OccupancyGrid;
import rsal.device.DeviceInfo;
import rsal.device.Mapper;
import rsal.device.SensorCore;

/// Maps nothing, and notes whether it would.
final class FakeMapper extends SensorCore<OccupancyGrid> implements Mapper {
    private boolean paused;

    FakeMapper(String robot, boolean paused) {
        super(new DeviceInfo(robot, "explorer", "fake"));
        this.paused = paused;
    }

    @Override
    public boolean isComplete() {
        return false;
    }

    @Override
    public void pause() {
        paused = true;
    }

    @Override
    public void resume() {
        paused = false;
    }

    @Override
    public boolean paused() {
        return paused;
    }
}
