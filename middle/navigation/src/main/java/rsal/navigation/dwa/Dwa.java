package rsal.navigation.dwa;

import java.util.Arrays;
import java.util.List;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.FootprintOutline;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;

/// Chooses among the velocities that the robot can reach soon: D. Fox, W. Burgard, S. Thrun, The Dynamic Window
/// Approach to Collision Avoidance (IEEE Robotics & Automation Magazine 4, 1997). Of the circular arcs of those
/// from which it can stop in time (equation 14) it takes the one that is best by heading, clearance and speed
/// (equation 13), smoothed over its neighbors.
///
/// Differs from the paper in these points:
/// * The outline is any convex one; the way along an arc is exact for it.
/// * Clearance and speed count as shares of how far it looks and of the highest speed.
/// * Where the best is to stand, it turns towards the target, or on in the sense that it has begun.
/// * The last word has [VelocityFilter].
public final class Dwa implements Controller {
    private static final int SPEEDS = 11;
    private static final int TURNS = 21;
    private static final double STANDING = 0.02; // m/s
    private static final double AHEAD = Math.toRadians(10);

    /// @param heading what it is worth to look at the target ("α")
    /// @param clearance what the way until something is hit is worth ("β")
    /// @param velocity what speed is worth ("γ")
    /// @param interval after which velocities must be reached [s]
    /// @param lookahead ways beyond this count as free [m]
    public record Settings(double heading, double clearance, double velocity, double interval, double lookahead) {
        /// With the weights that implementations of the method commonly have. As clearance and speed are shares here,
        /// they are a start to tune from, not what the paper measured with.
        public static Settings of(double interval, double lookahead) {
            return new Settings(2.0, 0.2, 0.2, interval, lookahead);
        }
    }

    private final Settings settings;
    private final DriveLimits limits;
    private final FootprintOutline outline;
    private final VelocityFilter caution;
    private final double[] values = new double[SPEEDS * TURNS];
    private final double[] distances = new double[SPEEDS * TURNS]; // m
    private int turning; // in place: 1 to the left, −1 to the right

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public Dwa(Footprint footprint, DriveLimits limits, Settings settings, double reaction) {
        this.settings = settings;
        this.limits = limits;
        this.outline = new FootprintOutline(footprint, VelocityFilter.MARGIN);
        this.caution = new VelocityFilter(footprint, limits, reaction);
    }

    @Override
    public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
        double most = limits.speed();
        if (target.arriving()) {
            most = Math.min(most, limits.arriving(target.distance()));
        }
        double gain = limits.acceleration() * settings.interval();
        double turnGain = limits.turnAcceleration() * settings.interval();
        double v = motion.velocity().vx();
        double w = motion.velocity().omega();
        double slowest = Math.clamp(v - gain, 0, most);
        double fastest = Math.clamp(v + gain, 0, most);
        double rightmost = Math.max(w - turnGain, -limits.turnRate());
        double leftmost = Math.min(w + turnGain, limits.turnRate());
        Arrays.fill(values, 0);
        for (int i = 0; i < SPEEDS; i++) {
            for (int j = 0; j < TURNS; j++) {
                double speed = mix(slowest, fastest, i, SPEEDS);
                double omega = mix(rightmost, leftmost, j, TURNS);
                int choice = i * TURNS + j;
                distances[choice] = free(speed, omega, obstacles);
                values[choice] = value(speed, omega, distances[choice], target);
            }
        }
        int best = best();
        double speed = mix(slowest, fastest, best / TURNS, SPEEDS);
        double omega = mix(rightmost, leftmost, best % TURNS, TURNS);
        if (values[best] == 0 || speed < STANDING) {
            return turnAway(obstacles, target, motion);
        }
        turning = 0;
        Twist2d command = caution.guarded(Twist2d.drive(speed, omega), motion.velocity(), obstacles);
        caution.upTo(target.arriving() ? Math.min(distances[best], target.distance()) : distances[best]);
        return command;
    }

    private static double mix(double from, double to, int i, int count) {
        return from + (to - from) * i / (count - 1);
    }

    /// The objective function; 0 when the velocity is not admissible.
    ///
    /// @param way how far the robot gets [m]
    private double value(double v, double w, double way, Target target) {
        boolean stopsInTime = v * v <= 2 * way * limits.acceleration()
                && (v < STANDING || w * w <= 2 * way * Math.abs(w / v) * limits.turnAcceleration());
        if (!stopsInTime) {
            return 0;
        }
        return settings.heading() * heading(v, w, target)
                + settings.clearance() * way / settings.lookahead()
                + settings.velocity() * v / limits.speed();
    }

    /// How far the robot gets until it hits something [m].
    private double free(double v, double w, Obstacles obstacles) {
        double way = settings.lookahead();
        if (v < STANDING) {
            return way;
        }
        for (int i = 0; i < obstacles.count(); i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            double reach = way + outline.reach();
            if (x * x + y * y < reach * reach) {
                way = Math.min(way, Math.max(0, outline.freeDistance(x, y, w / v) - obstacles.room(i)));
            }
        }
        return way;
    }

    /// How well the robot looks at the target after it has driven on for the interval and braked then, 0–1.
    private double heading(double v, double w, Target target) {
        double turned = w * settings.interval() + w * Math.abs(w) / (2 * limits.turnAcceleration());
        double driven = v * settings.interval() + v * v / (2 * limits.acceleration());
        double x = driven * Math.cos(turned / 2);
        double y = driven * Math.sin(turned / 2);
        double bearing = Math.atan2(target.place().y() - y, target.place().x() - x);
        return 1 - Math.abs(Angles.difference(turned, bearing)) / Math.PI;
    }

    /// The best of the admissible by the mean of what is around it in the window.
    private int best() {
        int best = 0;
        double most = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < SPEEDS; i++) {
            for (int j = 0; j < TURNS; j++) {
                double smooth = values[i * TURNS + j] == 0 ? Double.NEGATIVE_INFINITY : smoothed(i, j);
                if (smooth > most) {
                    most = smooth;
                    best = i * TURNS + j;
                }
            }
        }
        return best;
    }

    private double smoothed(int speed, int turn) {
        double sum = 0;
        int count = 0;
        for (int i = Math.max(0, speed - 1); i <= Math.min(SPEEDS - 1, speed + 1); i++) {
            for (int j = Math.max(0, turn - 1); j <= Math.min(TURNS - 1, turn + 1); j++) {
                sum += values[i * TURNS + j];
                count++;
            }
        }
        return sum / count;
    }

    private Twist2d turnAway(Obstacles obstacles, Target target, Motion motion) {
        if (turning == 0) {
            turning = target.bearing() >= 0 ? 1 : -1;
        }
        double missing = Math.abs(target.bearing()) > AHEAD ? target.bearing() : Math.PI / 2;
        return caution.turn(turning * Math.abs(missing), motion.velocity(), obstacles);
    }

    @Override
    public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
        return caution.turn(angle, motion.velocity(), obstacles);
    }

    @Override
    public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
        return caution.guarded(wanted, motion.velocity(), obstacles);
    }

    /// On the arc that it chose, until something would be hit.
    @Override
    public List<Point2d> predictedTrajectory() {
        return caution.predictedTrajectory();
    }

    @Override
    public void reset() {
        turning = 0;
        caution.reset();
    }
}
