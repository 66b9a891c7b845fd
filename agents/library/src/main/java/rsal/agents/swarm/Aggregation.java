package rsal.agents.swarm;

import java.util.List;
import rsal.data.Angles;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Probabilistic aggregation after O. Soysal and E. Şahin, "Probabilistic aggregation strategies in swarm robotic
/// systems" (IEEE Swarm Intelligence Symposium 2005): a robot walks at random until it has neighbors, approaches their
/// center, waits there, and leaves by chance, the more rarely the more neighbors it has. So small groups dissolve in
/// favor of large ones.
public final class Aggregation implements SwarmRuleType {
    static final Parameter<Double> CONTACT =
            Parameter.number("contact", 1.2, 0.3, 100, "m", "A robot that is nearer to a neighbor than this waits.");
    static final Parameter<Double> LEAVING = Parameter.number(
            "leaving", 0.1, 0, 1, "1/s", "Rate at which a robot without neighbors would leave; e times less for each.");
    static final Parameter<Double> WALK =
            Parameter.number("walk", 15, 0, 600, "s", "Time for which a robot that leaves heeds no neighbors.");

    private static final double TURN = Math.PI / 4; // of a walk at random, at most
    private static final double STRAIGHT = 3; // s
    private static final double WALL = 1; // m; nearer things turn it away

    @Override
    public String key() {
        return "aggregation";
    }

    @Override
    public String description() {
        return "The robots gather in one place, which nobody has chosen.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(CONTACT, LEAVING, WALK);
    }

    @Override
    public SwarmRule create(Arguments arguments) {
        return new Gathering(arguments.get(CONTACT), arguments.get(LEAVING), arguments.get(WALK));
    }

    private static final class Gathering implements SwarmRule {
        private final double contact;
        private final double leaving;
        private final double walk;
        private double before = Double.NaN; // s
        private double walksUntil = Double.NEGATIVE_INFINITY; // s
        private double turnsAt = Double.NEGATIVE_INFINITY; // s
        private double heading;

        Gathering(double contact, double leaving, double walk) {
            this.contact = contact;
            this.leaving = leaving;
            this.walk = walk;
        }

        @Override
        public Point2d velocity(SwarmView view) {
            double passed = Double.isNaN(before) ? 0 : view.time() - before;
            before = view.time();
            if (view.neighbors().isEmpty() || view.time() < walksUntil) {
                return walk(view);
            }
            Point2d center = SwarmRule.STAND;
            double nearest = Double.POSITIVE_INFINITY;
            for (SwarmView.Neighbor neighbor : view.neighbors()) {
                Point2d to = Vectors.between(view.mapFromBase(), neighbor.mapFromBase());
                center = Vectors.sum(center, 1, to);
                nearest = Math.min(nearest, Vectors.length(to));
            }
            if (nearest > contact) {
                return Vectors.withLength(center, view.speed());
            }
            double rate = leaving * StrictMath.exp(-view.neighbors().size());
            if (view.random().nextDouble() < rate * passed) {
                walksUntil = view.time() + walk;
                heading = Vectors.angle(center) + Math.PI;
                turnsAt = view.time() + STRAIGHT;
            }
            return SwarmRule.STAND;
        }

        private Point2d walk(SwarmView view) {
            Point2d wall = view.toObstacle();
            if (Vectors.length(wall) < WALL && Math.abs(Angles.wrap(Vectors.angle(wall) - heading)) < Math.PI / 2) {
                heading = Vectors.angle(wall)
                        + Math.PI
                        + TURN * (2 * view.random().nextDouble() - 1);
                turnsAt = view.time() + STRAIGHT;
            }
            if (view.time() >= turnsAt) {
                turnsAt = view.time() + STRAIGHT;
                heading = view.mapFromBase().theta() + TURN * (2 * view.random().nextDouble() - 1);
            }
            return Vectors.polar(view.speed(), heading);
        }
    }
}
