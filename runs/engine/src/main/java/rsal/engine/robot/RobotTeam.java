package rsal.engine.robot;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.device.Localizer;
import rsal.engine.arbitration.Teleoperation;
import rsal.engine.report.Teammate;
import rsal.robot.Robot;

/// The robots of a run. All calls on the run's thread.
public final class RobotTeam {
    private final Map<String, Robot> robots = new LinkedHashMap<>();
    private final Map<String, Teleoperation> teleoperation = new LinkedHashMap<>();
    private final Map<String, Teammate> cameSoFar = new LinkedHashMap<>();
    private Optional<List<Teammate>> mates = Optional.empty(); // made when somebody asks

    /// One that was there before keeps its place.
    ///
    /// @param robot as its agents have it
    /// @param reported by what people tell it what to do; empty when it has no drive
    public void join(Robot robot, Optional<Teleoperation> reported, Teammate mate) {
        robots.put(robot.id(), robot);
        reported.ifPresent(own -> teleoperation.put(robot.id(), own));
        cameSoFar.put(robot.id(), mate);
        mates = Optional.empty();
    }

    public void leave(String id) {
        robots.remove(id);
        teleoperation.remove(id);
    }

    /// Those that are there, by id, in the order in which they came.
    public Map<String, Robot> robots() {
        return Collections.unmodifiableMap(robots);
    }

    public boolean has(String id) {
        return robots.containsKey(id);
    }

    public Optional<Robot> robot(String id) {
        return Optional.ofNullable(robots.get(id));
    }

    /// By what people tell a robot what to do; empty when it has no drive or is not there.
    public Optional<Teleoperation> teleoperation(String id) {
        return Optional.ofNullable(teleoperation.get(id));
    }

    /// All there are now; who comes or leaves meanwhile does not change it.
    public List<Teleoperation> teleoperation() {
        return List.copyOf(teleoperation.values());
    }

    /// A robot's own, or else one that it was given to do what people told it.
    public Optional<Localizer> localizer(Robot robot) {
        return robot.find(Localizer.class)
                .or(() -> teleoperation(robot.id())
                        .flatMap(reported -> reported.outfit().find(Localizer.class)));
    }

    /// All that are or were there, in the order in which they came; the same list until it grows.
    public List<Teammate> mates() {
        List<Teammate> now = mates.orElseGet(() -> List.copyOf(cameSoFar.values()));
        mates = Optional.of(now);
        return now;
    }
}
