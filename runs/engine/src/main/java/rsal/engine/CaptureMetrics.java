package rsal.engine;

import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.Set;
import rsal.agent.message.Caught;
import rsal.data.Pose2d;
import rsal.data.Walls;
import rsal.engine.ReachedMetrics.There;

/// Which prey are caught in truth. A prey says which hunter has caught it, and how far away that is. It counts
/// from when that is true: this hunter, or another robot of its role, is so near, and no wall stands between.
final class CaptureMetrics {
    private static final double RIGHT = 1.0; // m by which a prey may be wrong about the distance
    private static final double SIDE = 0.3; // m from a hunter's middle; who is seen in part is in sight

    private final Walls walls;
    private final EventLog eventLog;
    private final Map<String, Claim> untrue = new LinkedHashMap<>(); // until now, by prey
    private final Map<String, OptionalDouble> caught = new HashMap<>(); // from how far [m], by prey

    /// @param role of the robot that the prey named
    private record Claim(String role, double distance) {}

    /// @param walls through which nobody is caught
    CaptureMetrics(Walls walls, EventLog eventLog) {
        this.walls = walls;
        this.eventLog = eventLog;
    }

    /// A prey says that it is caught. It is believed where nobody knows better.
    ///
    /// @param role of the hunter
    /// @param mapFromPrey where it really is; empty when nobody knows
    /// @return whether it counts, and did not before
    boolean heard(Caught said, String role, Optional<Pose2d> mapFromPrey, Optional<Pose2d> mapFromHunter) {
        if (caught.containsKey(said.prey())) {
            return false;
        }
        if (mapFromPrey.isEmpty() || mapFromHunter.isEmpty()) {
            caught.put(said.prey(), OptionalDouble.empty());
            return true;
        }
        Pose2d prey = mapFromPrey.get();
        Pose2d hunter = mapFromHunter.get();
        var claim = new Claim(role, said.distance());
        if (holds(claim, prey, hunter)) {
            count(said.prey(), prey.distanceTo(hunter));
            return true;
        }
        if (untrue.put(said.prey(), claim) == null) {
            eventLog.event(
                    "uncaught",
                    said.prey(),
                    "is not caught: '%s' is really %.2f m away%s"
                            .formatted(
                                    said.hunter(),
                                    prey.distanceTo(hunter),
                                    isInSight(prey, hunter) ? "" : ", behind a wall"));
        }
        return false;
    }

    /// A step is over.
    ///
    /// @param robots that are not gone
    /// @return prey of which it has become true now that they are caught
    Set<String> look(List<There> robots) {
        Map<String, Double> now = new LinkedHashMap<>(); // from how far [m]
        untrue.forEach((prey, claim) -> robots.stream()
                .filter(robot -> robot.robot().equals(prey))
                .findFirst()
                .ifPresent(there -> robots.stream()
                        .filter(robot -> robot.role().equals(claim.role)
                                && !robot.robot().equals(prey))
                        .filter(hunter -> holds(claim, there.mapFromBase(), hunter.mapFromBase()))
                        .mapToDouble(hunter -> there.mapFromBase().distanceTo(hunter.mapFromBase()))
                        .min()
                        .ifPresent(distance -> now.put(prey, distance))));
        now.forEach((prey, distance) -> {
            eventLog.event("caught", prey, "is really caught now, from %.2f m".formatted(distance));
            count(prey, distance);
        });
        return now.keySet();
    }

    private boolean holds(Claim claim, Pose2d mapFromPrey, Pose2d mapFromHunter) {
        return mapFromPrey.distanceTo(mapFromHunter) <= claim.distance + RIGHT && isInSight(mapFromPrey, mapFromHunter);
    }

    private boolean isInSight(Pose2d mapFromPrey, Pose2d mapFromHunter) {
        return !walls.hide(mapFromPrey.position(), mapFromHunter.position(), SIDE);
    }

    private void count(String prey, double distance) {
        untrue.remove(prey);
        caught.put(prey, OptionalDouble.of(distance));
    }

    /// Whether a prey has said that it is caught, and that was not true until now.
    boolean isWaiting() {
        return !untrue.isEmpty();
    }

    /// Prey that are caught.
    Set<String> caught() {
        return caught.keySet();
    }

    /// How far a hunter really was away from a prey when its capture counted [m]; empty when nobody knows.
    OptionalDouble distance(String prey) {
        return caught.getOrDefault(prey, OptionalDouble.empty());
    }
}
