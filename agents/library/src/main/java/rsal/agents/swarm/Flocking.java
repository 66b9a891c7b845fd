package rsal.agents.swarm;

import java.util.List;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Separation, alignment and cohesion after C. W. Reynolds, "Flocks, herds, and schools" (SIGGRAPH 1987), with the
/// noise of T. Vicsek et al., "Novel type of phase transition in a system of self-driven particles" (Physical Review
/// Letters 75, 1995). With cohesion and separation 0, only headings are aligned, as Vicsek has it.
///
/// Departure: speeds are equal, and robots turn at a limited rate.
public final class Flocking implements SwarmRuleType {
    static final Parameter<Double> SEPARATION =
            Parameter.number("separation", 1.5, 0, 100, "", "Weight of the distance from near neighbors.");
    static final Parameter<Double> ALIGNMENT =
            Parameter.number("alignment", 1, 0, 100, "", "Weight of the mean heading of neighbors.");
    static final Parameter<Double> COHESION =
            Parameter.number("cohesion", 0.4, 0, 100, "", "Weight of the direction to the center of neighbors.");
    static final Parameter<Double> DISTANCE =
            Parameter.number("distance", 1.5, 0.1, 100, "m", "Neighbors nearer than this are too near.");
    static final Parameter<Double> NOISE = Parameter.number(
            "noise", 0, 0, 360, "deg", "Range of a random angle that is added to the heading in each decision.");

    private static final double WALL = 1.5; // m; nearer things repel
    private static final double OBSTACLE = 4; // weight of their repulsion

    @Override
    public String key() {
        return "flocking";
    }

    @Override
    public String description() {
        return "The robots drive in the same direction, near each other.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(SEPARATION, ALIGNMENT, COHESION, DISTANCE, NOISE);
    }

    @Override
    public SwarmRule create(Arguments arguments) {
        double separation = arguments.get(SEPARATION);
        double alignment = arguments.get(ALIGNMENT);
        double cohesion = arguments.get(COHESION);
        double distance = arguments.get(DISTANCE);
        double noise = arguments.radians(NOISE);
        return view -> {
            Point2d away = SwarmRule.STAND;
            Point2d headings = Vectors.polar(1, view.mapFromBase().theta());
            Point2d center = SwarmRule.STAND;
            for (SwarmView.Neighbor neighbor : view.neighbors()) {
                Point2d to = Vectors.between(view.mapFromBase(), neighbor.mapFromBase());
                double gap = Math.max(0, 1 - Vectors.length(to) / distance);
                away = Vectors.sum(away, -gap, Vectors.withLength(to, 1));
                headings = Vectors.sum(
                        headings, 1, Vectors.polar(1, neighbor.mapFromBase().theta()));
                center = Vectors.sum(center, 1, to);
            }
            Point2d wanted = Vectors.withLength(headings, alignment);
            wanted = Vectors.sum(wanted, separation, away);
            wanted = Vectors.sum(wanted, cohesion, Vectors.withLength(center, 1));
            double free = Vectors.length(view.toObstacle()) / WALL;
            if (free < 1) {
                wanted = Vectors.sum(wanted, -OBSTACLE * (1 - free), Vectors.withLength(view.toObstacle(), 1));
            }
            double angle = Vectors.angle(wanted) + noise * (view.random().nextDouble() - 0.5);
            return Vectors.polar(view.speed(), angle);
        };
    }
}
