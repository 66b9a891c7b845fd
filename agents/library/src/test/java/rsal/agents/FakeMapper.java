package rsal.agents;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import rsal.data.OccupancyGrid;
import rsal.data.Stamped;
import rsal.device.DeviceInfo;
import rsal.device.Mapper;
import rsal.device.SensorCore;

/// Maps what a test tells it, and notes whether it would drive.
public final class FakeMapper extends SensorCore<OccupancyGrid> implements Mapper {
    private boolean paused;
    private boolean complete;
    public final List<End> leftAlone = new ArrayList<>();
    private List<End> ends = List.of();

    public FakeMapper(String robot, boolean paused) {
        super(new DeviceInfo(robot, "explorer", "fake"));
        this.paused = paused;
    }

    @Override
    public boolean isComplete() {
        return complete;
    }

    @Override
    public List<End> ends() {
        return ends;
    }

    @Override
    public void leaveAlone(End end) {
        leftAlone.add(end);
    }

    /// Has drawn a map that ends there.
    public void draws(List<End> newest, Instant now) {
        ends = newest;
        publish(now);
    }

    /// Has looked whether anything is left to map.
    public void isComplete(boolean value, Instant now) {
        complete = value;
        publish(now);
    }

    private void publish(Instant now) {
        var map = new OccupancyGrid(1, 1, 1, 0, 0, new byte[1]);
        deliver(new Stamped<>(now, "map", map));
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
