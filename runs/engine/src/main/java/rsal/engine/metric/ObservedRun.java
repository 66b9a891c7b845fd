package rsal.engine.metric;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalInt;
import rsal.data.Walls;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Standing;
import rsal.engine.event.EventLog;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.metric.SignalType;
import rsal.metric.ThingState;
import rsal.scenario.PlannedThings;
import rsal.scenario.PlannedThings.PlannedThing;

/// A run as its metrics see it.
final class ObservedRun implements RunState {
    private final MetricsObserver observer;
    private final Walls walls;
    private final EventLog eventLog;
    private final Map<String, String> groups = new HashMap<>(); // by name of a thing
    private final Map<String, OptionalInt> markers = new HashMap<>(); // also by name of a thing

    /// @param things that the scenario puts into the world
    ObservedRun(MetricsObserver observer, Walls walls, EventLog eventLog, List<PlannedThings> things) {
        this.observer = observer;
        this.walls = walls;
        this.eventLog = eventLog;
        for (PlannedThings group : things) {
            for (PlannedThing each : group.each()) {
                String name = each.thing().name();
                groups.put(name, group.name());
                markers.put(
                        name,
                        each.thing()
                                .marker()
                                .map(marker -> OptionalInt.of(marker.id()))
                                .orElse(OptionalInt.empty()));
            }
        }
    }

    @Override
    public double time() {
        return observer.time();
    }

    @Override
    public List<RobotState> robots() {
        return observer.robots();
    }

    @Override
    public Optional<RobotState> robot(String id) {
        return observer.robot(id);
    }

    @Override
    public List<ThingState> things() {
        return observer.simulation().map(SimulationControl::things).orElse(List.of()).stream()
                .map(this::thing)
                .toList();
    }

    private ThingState thing(Standing thing) {
        String name = thing.name();
        return new ThingState(
                name,
                groups.getOrDefault(name, ""),
                markers.getOrDefault(name, OptionalInt.empty()),
                thing.mapFromThing());
    }

    @Override
    public Walls walls() {
        return walls;
    }

    @Override
    public void sample(SignalType signal, double value) {
        observer.sample(signal, value);
    }

    @Override
    public void sample(SignalType signal, String robot, double value) {
        observer.sample(signal, robot, value);
    }

    @Override
    public void event(String kind, String subject, String text) {
        eventLog.event(kind, subject, text);
    }
}
