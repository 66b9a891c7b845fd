import java.util.List;
import rsal.data.Twist2d;
import rsal.navigation.control.ControllerType;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Drives straight to the next point of the planned path, the slower the nearer something is ahead.
public final class Cautious implements ControllerType {
    private static final Parameter<Double> ROOM =
            Parameter.number("room", 0.6, 0.1, 3, "m", "The robot slows down with less room ahead.");

    @Override
    public String key() {
        return "cautious";
    }

    @Override
    public String description() {
        return "Drives straight to the next point of the planned path, the slower the nearer something is ahead.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(ROOM);
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        return new Cautiously(driven, arguments.get(ROOM));
    }

    /// The controller of one robot. Poses and points are in its base frame: x ahead, y to the left [m].
    private static final class Cautiously implements Controller {
        private static final double AHEAD = Math.toRadians(40); // to each side

        private final double front; // from the base's origin [m]
        private final double room; // m
        private final VelocityFilter filter; // lets no command through that can't be stopped in time

        Cautiously(Driven driven, double room) {
            this.front = driven.footprint().circumscribedRadius();
            this.room = room;
            this.filter = new VelocityFilter(driven.footprint(), driven.limits(), driven.reaction());
        }

        @Override
        public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
            double share = Math.clamp((nearestAhead(obstacles) - front) / room, 0.1, 1);
            return filter.towards(target.bearing(), share, target, motion, obstacles);
        }

        private static double nearestAhead(Obstacles obstacles) {
            double nearest = Double.POSITIVE_INFINITY;
            for (int i = 0; i < obstacles.count(); i++) {
                if (Math.abs(Math.atan2(obstacles.y(i), obstacles.x(i))) < AHEAD) {
                    nearest = Math.min(nearest, Math.hypot(obstacles.x(i), obstacles.y(i)));
                }
            }
            return nearest;
        }

        @Override
        public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
            return filter.turn(angle, motion.velocity(), obstacles);
        }

        @Override
        public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
            return filter.guarded(wanted, motion.velocity(), obstacles);
        }

        @Override
        public void reset() {
            filter.reset();
        }
    }
}
