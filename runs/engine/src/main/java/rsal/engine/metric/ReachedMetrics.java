package rsal.engine.metric;

import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import rsal.data.Pose2d;
import rsal.data.Walls;
import rsal.device.SimulationControl.Standing;
import rsal.engine.event.EventLog;
import rsal.scenario.PlannedThings;
import rsal.scenario.PlannedThings.PlannedThing;
import rsal.scenario.PlannedThings.Reach;

/// Knows to which things robots have got that were to, in truth: whatever agents believe.
final class ReachedMetrics {
    private final Walls walls;
    private final EventLog eventLog;
    private final Map<String, PlannedThings> groups = new LinkedHashMap<>(); // by name of a thing
    private final Map<Stay, Double> since = new HashMap<>(); // [s]
    private final Set<String> reached = new HashSet<>(); // things

    private record Stay(String robot, String thing) {}

    /// Where a robot really is.
    record There(String robot, String role, Pose2d mapFromBase) {}

    /// @param walls through which nobody gets to anything
    ReachedMetrics(List<PlannedThings> things, Walls walls, EventLog eventLog) {
        this.walls = walls;
        this.eventLog = eventLog;
        for (PlannedThings group : things) {
            if (group.reach().isPresent()) {
                for (PlannedThing each : group.each()) {
                    groups.put(each.thing().name(), group);
                }
            }
        }
    }

    /// Whether there is anything to look at.
    boolean isWanted() {
        return !groups.isEmpty();
    }

    /// @param robots that are not gone
    /// @param now since the run's start [s]
    void look(List<Standing> things, List<There> robots, double now) {
        for (Standing thing : things) {
            PlannedThings group = groups.get(thing.name());
            if (group != null && !reached.contains(thing.name())) {
                Reach reach = group.reach().orElseThrow();
                robots.forEach(robot -> look(thing, reach, robot, now));
            }
        }
    }

    private void look(Standing thing, Reach reach, There robot, double now) {
        var stay = new Stay(robot.robot(), thing.name());
        double distance = robot.mapFromBase().distanceTo(thing.mapFromThing());
        boolean there = reach.counts(robot.role())
                && distance <= reach.within()
                && !walls.standBetween(
                        robot.mapFromBase().position(), thing.mapFromThing().position());
        if (!there) {
            since.remove(stay);
            return;
        }
        double stayed = now - since.computeIfAbsent(stay, _ -> now);
        if (stayed >= reach.stays().toMillis() / 1000.0 && reached.add(thing.name())) {
            eventLog.event("reached", thing.name(), "has %s with it".formatted(robot.robot()));
        }
    }

    /// How many of a group a robot has got to.
    int reached(String group) {
        return among(reached, group);
    }

    private int among(Set<String> things, String group) {
        return (int) things.stream()
                .filter(thing -> Optional.ofNullable(groups.get(thing))
                        .filter(own -> own.name().equals(group))
                        .isPresent())
                .count();
    }
}
