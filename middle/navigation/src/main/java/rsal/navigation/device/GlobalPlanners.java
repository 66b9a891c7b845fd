package rsal.navigation.device;

import java.util.List;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.navigation.avoid.VelocityFilter;
import rsal.navigation.control.PlannerType;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.jumppoint.JumpPoints;
import rsal.navigation.passage.Passages;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.CostMap.Clearance;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.navigation.wavefront.Wavefront;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;

/// The global planners of robots of one size, shared by all that have the same size and settings.
final class GlobalPlanners {
    private static final Parameter<Double> COMFORT_DISTANCE =
            Parameter.number("comfortDistance", 0.5, 0, 5, "m", "clearance from which on a path has no extra cost");
    private static final Parameter<Double> WALL_COST =
            Parameter.number("wallCost", 3, 0, 5, "", "how many times longer a path may be to keep away from walls");

    static final Parameter<Double> WALL_DISTANCE = Parameter.number(
            "wallDistance", 0.1, 0, 2, "m", "minimum clearance between the robot and a wall on a path");

    private record Key(OccupancyGrid map, Clearance clearance) {}

    private final ComputedOnce<OccupancyGrid, DistanceField> fields = new ComputedOnce<>();
    private final ComputedOnce<Key, Wavefront> ways = new ComputedOnce<>();
    private final ComputedOnce<Key, JumpPoints> shortest = new ComputedOnce<>();
    private final ComputedOnce<Planned, GlobalPlanner> planners = new ComputedOnce<>();

    private final ComputedOnce<Narrow, Passages> passages = new ComputedOnce<>();

    private record Narrow(Key key, double body) {}

    private record Planned(Key key, PluginChoice planner) {}

    static List<Parameter<?>> parameters() {
        return List.of(WALL_DISTANCE, COMFORT_DISTANCE, WALL_COST);
    }

    /// What its [#parameters] say for a robot that counts as a circle: the one that fits into its outline, since it
    /// can turn where the way does.
    static Clearance clearance(Footprint footprint, Arguments arguments) {
        double radius = footprint.inscribedRadius();
        double least = least(footprint, arguments);
        return new Clearance(
                least, Math.max(least, radius + arguments.get(COMFORT_DISTANCE)), arguments.get(WALL_COST));
    }

    /// How near it comes to walls at most [m].
    private static double least(Footprint footprint, Arguments arguments) {
        return footprint.inscribedRadius() + VelocityFilter.room(footprint, arguments.get(WALL_DISTANCE));
    }

    /// For a robot with such a [#clearance].
    Wavefront of(OccupancyGrid map, Footprint footprint, Arguments arguments) {
        Clearance clearance = clearance(footprint, arguments);
        return ways.of(new Key(map, clearance), _ -> new Wavefront(CostMap.of(map, field(map), clearance)));
    }

    /// A planner that somebody chose, for a robot with such a [#clearance].
    GlobalPlanner planner(OccupancyGrid map, Footprint footprint, Arguments arguments, PluginChoice chosen) {
        var key = new Key(map, clearance(footprint, arguments));
        return planners.of(
                new Planned(key, chosen),
                _ -> chosen.as(PlannerType.class)
                        .create(chosen.arguments(), CostMap.of(map, field(map), key.clearance)));
    }

    /// Where two such robots cannot pass each other.
    Passages passages(OccupancyGrid map, Footprint footprint, Arguments arguments) {
        Clearance clearance = clearance(footprint, arguments);
        double body = footprint.circumscribedRadius();
        return passages.of(
                new Narrow(new Key(map, clearance), body),
                _ -> Passages.of(CostMap.of(map, field(map), clearance), field(map), body));
    }

    /// Who looks for shortest ways for such a robot.
    JumpPoints shortest(OccupancyGrid map, Footprint footprint, Arguments arguments) {
        double least = least(footprint, arguments);
        var clearance = new Clearance(least, least, 0);
        return shortest.of(new Key(map, clearance), _ -> new JumpPoints(CostMap.of(map, field(map), clearance)));
    }

    /// How far the next place is that is not known to be free.
    DistanceField field(OccupancyGrid map) {
        return fields.of(map, DistanceField::toNotFree);
    }
}
