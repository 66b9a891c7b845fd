package rsal.engine.metric;

import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Set;
import java.util.stream.Collectors;
import rsal.data.Point2d;
import rsal.engine.metric.ReachedMetrics.There;
import rsal.metric.QuantityType;
import rsal.scenario.Place;
import rsal.scenario.condition.RunQuantities;

/// Where robots truly are after each step, as far as somebody asks: how far from each other, in which places,
/// and how often they came there.
final class PositionMetrics {
    /// What it is asked for.
    static final Set<QuantityType> QUANTITIES =
            Set.of(RunQuantities.DISTANCE, RunQuantities.WITHIN, RunQuantities.VISITS);

    /// How far a robot must get out of a place until it can come again [m]: who turns at the border comes once.
    private static final double OUT = 0.1;

    private final Map<String, Place.Area> places;
    private final Map<Stay, Boolean> inside = new HashMap<>();
    private final Map<Visit, Integer> visits = new HashMap<>();
    private List<There> robots = List.of();

    private record Stay(String robot, String place) {}

    private record Visit(String role, String place) {}

    PositionMetrics(List<Place> places) {
        this.places = places.stream().collect(Collectors.toMap(Place::name, Place::area));
    }

    /// A step is over.
    ///
    /// @param there robots that are not gone
    void look(List<There> there) {
        robots = there;
        places.forEach((name, area) -> there.forEach(robot -> look(robot, name, area)));
        Set<String> present = new HashSet<>();
        there.forEach(robot -> present.add(robot.robot()));
        inside.keySet().removeIf(stay -> !present.contains(stay.robot));
    }

    private void look(There robot, String place, Place.Area area) {
        Point2d at = robot.mapFromBase().position();
        var stay = new Stay(robot.robot(), place);
        Boolean before = inside.get(stay);
        boolean now = area.holds(at, Boolean.TRUE.equals(before) ? OUT : 0);
        inside.put(stay, now);
        if (now && Boolean.FALSE.equals(before)) {
            visits.merge(new Visit(robot.role(), place), 1, Integer::sum);
        }
    }

    /// Of the two nearest robots of two roles [m]; NaN while there are no two.
    double distance(String role, String other) {
        double least = Double.NaN;
        for (There one : robots) {
            if (one.role().equals(role)) {
                for (There another : robots) {
                    if (another.role().equals(other) && !another.robot().equals(one.robot())) {
                        double distance = one.mapFromBase().distanceTo(another.mapFromBase());
                        least = Double.isNaN(least) ? distance : Math.min(least, distance);
                    }
                }
            }
        }
        return least;
    }

    /// How many robots of a role are in a place.
    int within(String role, String place) {
        Place.Area area = Objects.requireNonNull(places.get(place)); // else the scenario was refused
        return (int) robots.stream()
                .filter(robot -> robot.role().equals(role))
                .filter(robot -> area.holds(robot.mapFromBase().position(), 0))
                .count();
    }

    /// How often robots of a role have come into a place.
    int visits(String role, String place) {
        return visits.getOrDefault(new Visit(role, place), 0);
    }
}
