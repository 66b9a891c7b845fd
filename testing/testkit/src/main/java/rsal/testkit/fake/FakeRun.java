package rsal.testkit.fake;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Walls;
import rsal.metric.RobotState;
import rsal.metric.RunState;
import rsal.metric.SignalType;
import rsal.metric.ThingState;

/// A run for tests of metrics: time, robots and things are as the test says, and what the metric notes is kept.
public final class FakeRun implements RunState {
    private final Walls walls;
    private final Map<String, RobotState> robots = new LinkedHashMap<>();
    private final List<ThingState> things = new ArrayList<>();
    private final List<Sample> samples = new ArrayList<>();
    private final List<Event> events = new ArrayList<>();
    private double time;

    /// @param robot its id; empty for a sample of the whole run
    public record Sample(String signal, String robot, double value) {}

    public record Event(String kind, String subject, String text) {}

    /// On a floor without walls.
    public FakeRun() {
        this(new OccupancyGrid(1, 1, 1, 0, 0, new byte[] {OccupancyGrid.FREE}));
    }

    public FakeRun(OccupancyGrid map) {
        walls = new Walls(map);
    }

    /// It is so late now [s].
    public void at(double seconds) {
        time = seconds;
    }

    /// A robot truly is somewhere.
    public void place(String id, String role, Pose2d mapFromBase) {
        robots.put(id, new RobotState(id, role, Optional.of(mapFromBase), true));
    }

    /// Nobody knows where a robot is.
    public void placeNowhere(String id, String role) {
        robots.put(id, new RobotState(id, role, Optional.empty(), false));
    }

    /// A thing stands somewhere.
    public void place(ThingState thing) {
        things.add(thing);
    }

    /// What the metric has noted so far, oldest first.
    public List<Sample> samples() {
        return List.copyOf(samples);
    }

    /// What the metric has told so far, oldest first.
    public List<Event> events() {
        return List.copyOf(events);
    }

    @Override
    public double time() {
        return time;
    }

    @Override
    public List<RobotState> robots() {
        return List.copyOf(robots.values());
    }

    @Override
    public Optional<RobotState> robot(String id) {
        return Optional.ofNullable(robots.get(id));
    }

    @Override
    public List<ThingState> things() {
        return List.copyOf(things);
    }

    @Override
    public Walls walls() {
        return walls;
    }

    @Override
    public void sample(SignalType signal, double value) {
        samples.add(new Sample(signal.word(), "", value));
    }

    @Override
    public void sample(SignalType signal, String robot, double value) {
        samples.add(new Sample(signal.word(), robot, value));
    }

    @Override
    public void event(String kind, String subject, String text) {
        events.add(new Event(kind, subject, text));
    }
}
