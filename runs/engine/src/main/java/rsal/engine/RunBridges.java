package rsal.engine;

import java.io.IOException;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import rsal.engine.event.EventLog;
import rsal.robot.Robot;
import rsal.system.Bridge;
import rsal.system.ExportedDevice;

/// To whom the robots of a run are offered. Of the run's thread.
final class RunBridges implements AutoCloseable {
    private final EventLog eventLog;
    private final List<Bridge> bridges = new ArrayList<>();

    RunBridges(EventLog eventLog) {
        this.eventLog = eventLog;
    }

    void add(Bridge bridge) {
        bridges.add(bridge);
    }

    /// Whether a program that robots are offered to has yet to look at what there is.
    boolean isAwaited() {
        return bridges.stream().anyMatch(Bridge::isBehind);
    }

    /// How such programs hold the run back: the strictest.
    Bridge.Pace pace() {
        Bridge.Pace strictest = Bridge.Pace.FREE;
        for (Bridge bridge : bridges) { // for each part of a step
            Bridge.Pace pace = bridge.pace();
            strictest = pace.compareTo(strictest) > 0 ? pace : strictest;
        }
        return strictest;
    }

    /// For how long time may go on at once, where it goes on for a while.
    Duration grain(Duration whole) {
        Duration least = whole;
        for (Bridge bridge : bridges) {
            Duration grain = bridge.grain().orElse(whole);
            least = grain.compareTo(least) < 0 ? grain : least;
        }
        return least;
    }

    void join(Robot robot) {
        bridges.forEach(bridge -> offer(bridge, robot));
    }

    private void offer(Bridge bridge, Robot robot) {
        try {
            bridge.join(robot).stream()
                    .mapToInt(ExportedDevice::port)
                    .distinct()
                    .forEach(port -> eventLog.event("bridge", robot.id(), "is offered at port " + port));
        } catch (IOException e) {
            eventLog.event("bridge", robot.id(), "is not offered: " + e.getMessage());
        }
    }

    void leave(String robot) {
        bridges.forEach(bridge -> bridge.leave(robot));
    }

    @Override
    public void close() {
        bridges.forEach(Bridge::close);
    }
}
