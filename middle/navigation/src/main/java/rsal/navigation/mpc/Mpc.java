package rsal.navigation.mpc;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;

/// Model-predictive control by sampling. Remembers what it saw in a [RollingMap], knows by a [TimeField] how
/// long the way to the target takes from everywhere on it, and drives many ways through the next seconds in its
/// head: each follows the accelerations that the robot is able of, and ends with the time that is left from
/// there. It does what the quickest of them begins with, and looks again.
///
/// After G. Williams and others, Information Theoretic MPC for Model-Based Reinforcement Learning (ICRA 2017),
/// from whose algorithm (MPPI) it has the sampling around the last plan, moved on by the time since, and O.
/// Brock, O. Khatib, High-speed Navigation Using the Global Dynamic Window Approach (ICRA 1999), from which it
/// has the navigation function as what is left to do.
///
/// Differs from Williams in these points:
/// * The best sample counts, not the mean weighted by costs, which may lie between two sides of a post. So
///   there is no temperature ("λ"), and no cost of the noise.
/// * Samples are drawn closer in a few rounds, each around the best so far. That is like the cross-entropy
///   method (R. Rubinstein, The Cross-Entropy Method for Combinatorial and Continuous Optimization, Methodology
///   and Computing in Applied Probability 1, 1999) with an elite of one and spreads that are halved, not
///   measured.
/// * Some samples are the same each time, so that it never gets stuck in its last plan.
/// * The model is that of a drive with limits, not learned.
///
/// Differs from Brock and Khatib in that what is left is a time, not a count of cells (NF1), and in that it
/// plans four pieces of a way of more than a second, not one arc.
///
/// The random numbers are its own and the same in each call. The last word has [VelocityFilter].
public final class Mpc implements Controller {
    private static final int KNOTS = 4;
    private static final int STEPS_PER_KNOT = 6;
    private static final int STEPS = KNOTS * STEPS_PER_KNOT;
    private static final int STEPS_PER_POINT = 3;
    private static final double DT = 0.06; // s
    private static final double KNOT = STEPS_PER_KNOT * DT; // s
    private static final int ROUNDS = 4;
    private static final int SAMPLES = 48;
    private static final double RESOLUTION = 0.05; // m
    private static final double MEMORY = 60; // s

    // of the highest speed, not backward, where robots seldom look
    private static final double[] SPEEDS = {1, 0.6, 0.3, 0.1, 0};
    private static final double[] TURNS = {-1, -0.6, -0.3, -0.12, 0, 0.12, 0.3, 0.6, 1}; // of the highest turn rate
    private static final double[] THEN = {-0.6, -0.2, 0, 0.2, 0.6}; // the same, from the second knot on

    private static final double HOPELESS = 1e3; // cost of touching anything
    private static final double TOO_FAST = 3; // per m/s and s
    private static final double LATER = 0.3; // per rad/s of change
    private static final double BELOW_SPEED = 0.35; // s per share of the highest speed
    private static final double MISALIGNED = 0.35; // s/rad

    private final DriveLimits limits;
    private final VelocityFilter caution;
    private final Settings settings;
    private final RollingMap map;
    private final TimeField field;
    private final double inner;
    private final double outer;
    private final double[] outlineX;
    private final double[] outlineY;
    private final double beat;
    private final double[] noise;

    private double[] plan = new double[2 * KNOTS]; // v and ω, knot by knot
    private double[] trial = new double[2 * KNOTS];
    private double[] best = new double[2 * KNOTS];
    private boolean planned;
    private Motion from = new Motion(Pose2d.ORIGIN, Twist2d.STOP); // where it made the plan
    private Target target = Target.at(new Point2d(0, 0), true);
    private double goalX;
    private double goalY;

    /// @param view side of the square around the robot that it plans in [m]
    /// @param margin room between outline and obstacles that it plans with [m]
    /// @param creep speed where the outline is as near as it may be [m/s]
    /// @param speedPerRoom how much faster it may be with more room [1/s]
    public record Settings(double view, double margin, double creep, double speedPerRoom) {
        public static final Settings DEFAULT = new Settings(10, 0.05, 0.5, 4);
    }

    /// @param reaction how long a command lasts before the next one can take effect [s]
    /// @param beat between two calls [s]
    public Mpc(Footprint footprint, DriveLimits limits, Settings settings, double reaction, double beat) {
        this.limits = limits;
        this.settings = settings;
        this.beat = beat;
        this.caution = new VelocityFilter(footprint, limits, reaction);
        this.inner = footprint.inscribedRadius();
        this.outer = footprint.circumscribedRadius();
        this.map = new RollingMap((int) Math.round(settings.view() / RESOLUTION), RESOLUTION, MEMORY / beat);
        this.field = new TimeField(map, this::speedAmidst);
        double[][] samples = samples(footprint);
        this.outlineX = samples[0];
        this.outlineY = samples[1];
        var random = new SplittableRandom(1);
        this.noise = new double[ROUNDS * SAMPLES * 2 * KNOTS];
        for (int i = 0; i < noise.length; i++) {
            noise[i] = random.nextGaussian();
        }
    }

    /// Points of the outline, about as far apart as two cells.
    static double[][] samples(Footprint footprint) {
        var corners = footprint.corners();
        int[] perSide = new int[corners.size()];
        int count = 0;
        for (int i = 0; i < perSide.length; i++) {
            double length = corners.get(i).distanceTo(corners.get((i + 1) % perSide.length));
            perSide[i] = Math.max(1, (int) Math.ceil(length / (2 * RESOLUTION)));
            count += perSide[i];
        }
        var points = new double[2][count];
        int k = 0;
        for (int i = 0; i < perSide.length; i++) {
            Point2d a = corners.get(i);
            Point2d b = corners.get((i + 1) % perSide.length);
            for (int j = 0; j < perSide[i]; j++, k++) {
                points[0][k] = a.x() + (b.x() - a.x()) * j / perSide[i];
                points[1][k] = a.y() + (b.y() - a.y()) * j / perSide[i];
            }
        }
        return points;
    }

    /// How fast a robot may be whose base is so far from the next obstacle, whichever way it looks.
    double speedAmidst(double distance) {
        double room = distance - outer - settings.margin();
        if (distance < inner + settings.margin()) {
            return 0;
        }
        return room < 0
                ? 0.15 * Math.min(1, limits.speed())
                : Math.min(limits.speed(), settings.creep() + settings.speedPerRoom() * room);
    }

    @Override
    public Twist2d drive(Obstacles obstacles, Target to, Motion motion) {
        Pose2d pose = motion.odomFromBase();
        target = to;
        map.note(obstacles, pose);
        Point2d goal = pose.transform(goal(to));
        goalX = goal.x();
        goalY = goal.y();
        field.spread(goal, pose.position());
        double cost = search(motion);
        if (cost >= HOPELESS) {
            planned = false;
            return turnToWay(obstacles, motion);
        }
        planned = true;
        from = motion;
        System.arraycopy(best, 0, plan, 0, plan.length);
        return caution.guarded(Twist2d.drive(best[0], best[1]), motion.velocity(), obstacles);
    }

    /// Where the planned way leaves what is in view, or its end; the target, when nobody planned.
    Point2d goal(Target to) {
        if (to.path().isEmpty()) {
            return to.place();
        }
        double half = settings.view() / 2 - 1.5;
        Point2d goal = to.path().getFirst();
        for (Point2d next : to.path()) {
            double reach = Math.max(Math.abs(next.x()), Math.abs(next.y()));
            if (reach > half) {
                double from = Math.max(Math.abs(goal.x()), Math.abs(goal.y()));
                double share = Math.max(0, (half - from) / (reach - from));
                return new Point2d(goal.x() + share * (next.x() - goal.x()), goal.y() + share * (next.y() - goal.y()));
            }
            goal = next;
        }
        return goal;
    }

    private Twist2d turnToWay(Obstacles obstacles, Motion motion) {
        Pose2d pose = motion.odomFromBase();
        double way = field.direction(pose.x(), pose.y());
        double angle = Double.isNaN(way) ? target.bearing() : Angles.difference(pose.theta(), way);
        return caution.turn(angle, motion.velocity(), obstacles);
    }

    /// Finds the best plan.
    ///
    /// @return its cost
    double search(Motion motion) {
        double least = Double.POSITIVE_INFINITY;
        if (planned) {
            for (int k = 0; k < KNOTS; k++) {
                double share = Math.min(1, beat / KNOT);
                int next = Math.min(KNOTS - 1, k + 1);
                trial[2 * k] = plan[2 * k] + share * (plan[2 * next] - plan[2 * k]);
                trial[2 * k + 1] = plan[2 * k + 1] + share * (plan[2 * next + 1] - plan[2 * k + 1]);
            }
            least = consider(least, motion);
        }
        for (double speed : SPEEDS) {
            for (double first : TURNS) {
                for (double then : THEN) {
                    for (int k = 0; k < KNOTS; k++) {
                        trial[2 * k] = speed * limits.speed();
                        trial[2 * k + 1] = (k == 0 ? first : then) * limits.turnRate();
                    }
                    least = consider(least, motion);
                }
            }
        }
        int i = 0;
        double spread = 0.4;
        var middle = new double[2 * KNOTS];
        for (int round = 0; round < ROUNDS; round++) {
            System.arraycopy(best, 0, middle, 0, middle.length);
            for (int sample = 0; sample < SAMPLES; sample++) {
                for (int k = 0; k < KNOTS; k++) {
                    double v = middle[2 * k] + spread * limits.speed() * noise[i++];
                    double w = middle[2 * k + 1] + spread * limits.turnRate() * noise[i++];
                    trial[2 * k] = Math.clamp(v, 0, limits.speed());
                    trial[2 * k + 1] = Math.clamp(w, -limits.turnRate(), limits.turnRate());
                }
                least = consider(least, motion);
            }
            spread /= 2;
        }
        return least;
    }

    private double consider(double least, Motion motion) {
        double cost = cost(trial, motion, least);
        if (cost < least) {
            System.arraycopy(trial, 0, best, 0, best.length);
            return cost;
        }
        return least;
    }

    /// Drives through a trial.
    ///
    /// @param tried v [m/s] and ω [rad/s], knot by knot
    /// @param enough a cost above which it need not be known
    double cost(double[] tried, Motion motion, double enough) {
        double x = motion.odomFromBase().x();
        double y = motion.odomFromBase().y();
        double theta = motion.odomFromBase().theta();
        double v = motion.velocity().vx();
        double w = motion.velocity().omega();
        double cost = LATER * Math.abs(tried[1] - w) / limits.turnRate();
        double gain = limits.acceleration() * DT;
        double turnGain = limits.turnAcceleration() * DT;
        double room = 0;
        for (int step = 0; step < STEPS; step++) {
            int knot = step / STEPS_PER_KNOT;
            v += Math.clamp(tried[2 * knot] - v, -gain, gain);
            w += Math.clamp(tried[2 * knot + 1] - w, -turnGain, turnGain);
            theta += w * DT;
            x += v * DT * Math.cos(theta - w * DT / 2);
            y += v * DT * Math.sin(theta - w * DT / 2);
            room = room(x, y, theta);
            if (room < 0) {
                return HOPELESS * (2 - (double) step / STEPS);
            }
            double safe = settings.creep() + settings.speedPerRoom() * room;
            cost += DT * TOO_FAST * Math.max(0, Math.abs(v) - safe);
            if (cost > enough) {
                return cost;
            }
            if (arrives(x, y)) {
                return cost + (step + 1) * DT - KNOTS * KNOT;
            }
        }
        double left = field.at(x, y);
        double way = field.direction(x, y);
        double turn = Double.isNaN(way) ? 0 : Math.abs(Angles.difference(theta, way));
        double fast = Math.min(limits.speed(), settings.creep() + settings.speedPerRoom() * room);
        return cost + left + MISALIGNED * turn + BELOW_SPEED * Math.max(0, fast - v) / limits.speed();
    }

    private boolean arrives(double x, double y) {
        return Math.hypot(x - goalX, y - goalY) < 0.15;
    }

    /// Between the outline and what is nearest, less the margin [m]; negative when that is not kept.
    double room(double x, double y, double theta) {
        double middle = map.distance(x, y);
        if (middle - outer > settings.margin() + 0.5) {
            return middle - outer - settings.margin();
        }
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        float least = Float.POSITIVE_INFINITY;
        for (int i = 0; i < outlineX.length; i++) {
            float distance =
                    map.distance(x + cos * outlineX[i] - sin * outlineY[i], y + sin * outlineX[i] + cos * outlineY[i]);
            if (distance < settings.margin()) {
                return -1;
            }
            least = Math.min(least, distance);
        }
        return least - settings.margin();
    }

    @Override
    public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
        planned = false;
        return caution.turn(angle, motion.velocity(), obstacles);
    }

    @Override
    public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
        planned = false;
        return caution.guarded(wanted, motion.velocity(), obstacles);
    }

    /// The best of those that it drove in its head, as far as that is to lead; where it has none, where it was let go.
    @Override
    public List<Point2d> predictedTrajectory() {
        List<Point2d> let = caution.predictedTrajectory();
        return planned && !let.isEmpty() ? rollout() : let;
    }

    /// Drives through the plan, as [#cost] does through a trial.
    private List<Point2d> rollout() {
        Pose2d baseFromOdom = from.odomFromBase().inverse();
        double x = from.odomFromBase().x();
        double y = from.odomFromBase().y();
        double theta = from.odomFromBase().theta();
        double v = from.velocity().vx();
        double w = from.velocity().omega();
        double gain = limits.acceleration() * DT;
        double turnGain = limits.turnAcceleration() * DT;
        var points = new ArrayList<Point2d>(STEPS / STEPS_PER_POINT + 1);
        points.add(new Point2d(0, 0));
        for (int step = 0; step < STEPS; step++) {
            int knot = step / STEPS_PER_KNOT;
            v += Math.clamp(plan[2 * knot] - v, -gain, gain);
            w += Math.clamp(plan[2 * knot + 1] - w, -turnGain, turnGain);
            theta += w * DT;
            x += v * DT * Math.cos(theta - w * DT / 2);
            y += v * DT * Math.sin(theta - w * DT / 2);
            boolean there = arrives(x, y);
            if (there || (step + 1) % STEPS_PER_POINT == 0) {
                points.add(baseFromOdom.transform(new Point2d(x, y)));
            }
            if (there) {
                break;
            }
        }
        return points;
    }

    @Override
    public void reset() {
        planned = false;
        map.reset();
        caution.reset();
    }
}
