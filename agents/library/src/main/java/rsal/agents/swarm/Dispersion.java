package rsal.agents.swarm;

import java.util.List;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Robots repel each other like equal charges, after A. Howard, M. J. Matarić and G. S. Sukhatme, "Mobile sensor
/// network deployment using potential fields" (DARS 2002).
///
/// Departures: walls repel only within a meter. A robot stands where the forces are weak, instead of friction.
public final class Dispersion implements SwarmRuleType {
    static final Parameter<Double> DISTANCE = Parameter.number(
            "distance", 3.5, 0.3, 1000, "m", "A robot stands while all neighbors are at least as far away.");
    private static final double GAIN = 1; // 1/s
    private static final double WALL = 1; // m; nearer things repel

    @Override
    public String key() {
        return "dispersion";
    }

    @Override
    public String description() {
        return "The robots keep away from each other, and so distribute themselves.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(DISTANCE);
    }

    @Override
    public SwarmRule create(Arguments arguments) {
        double distance = arguments.get(DISTANCE);
        return view -> {
            Point2d force = SwarmRule.STAND;
            for (SwarmView.Neighbor neighbor : view.neighbors()) {
                Point2d to = Vectors.between(view.mapFromBase(), neighbor.mapFromBase());
                double length = Vectors.length(to);
                if (length < distance) {
                    double strength = distance / Math.max(0.1, length) - 1;
                    force = Vectors.sum(force, -GAIN * strength, Vectors.withLength(to, 1));
                }
            }
            double wall = Vectors.length(view.toObstacle());
            if (wall < WALL) {
                force = Vectors.sum(
                        force, -GAIN * (WALL / Math.max(0.1, wall) - 1), Vectors.withLength(view.toObstacle(), 1));
            }
            return Vectors.length(force) < 0.1 ? SwarmRule.STAND : Vectors.atMost(force, view.speed());
        };
    }
}
