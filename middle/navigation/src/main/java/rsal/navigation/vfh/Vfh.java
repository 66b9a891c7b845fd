package rsal.navigation.vfh;

import java.util.Arrays;
import java.util.List;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.VelocityFilter;

/// Chooses a direction by a polar histogram of obstacles: I. Ulrich, J. Borenstein, VFH+: Reliable Obstacle
/// Avoidance for Fast Mobile Robots (ICRA 1998), in the four stages of its section 2:
/// * the primary polar histogram (2.1): obstacles grown by the robot's radius and a safety distance;
/// * the binary one (2.2), by two thresholds with hysteresis;
/// * the masked one (2.3), by the circles that the robot can turn on;
/// * the steering direction (2.4): of candidates in narrow and wide openings the one with the least sum of
///   three weighted angles, of which that to the target must weigh more than the other two together. The
///   weights are those that its implementations have as defaults.
///
/// Differs from the paper in these points:
/// * The histogram is made of what the sensors see now, not of a certainty grid, and holds the nearest obstacle
///   per direction, not a sum, so that it does not depend on how many beams a scan has. The thresholds with
///   hysteresis are distances.
/// * Obstacles behind the target do not count.
/// * The target is a candidate wherever it lies in an opening, in a narrow one and at the edges of a wide one,
///   too: openings are those of grown obstacles already.
/// * Circles have the radius that the measured speed and the highest turn rate make; only what is ahead bars
///   turns.
/// * The safety distance grows with speed the other way round: directions are open as at standstill, and the
///   room beside the chosen one says how fast it may be taken.
/// * The last word has [VelocityFilter].
///
/// Keeps the last histogram and direction, so each robot needs its own.
public final class Vfh implements Controller {
    private static final double WIDE = Math.toRadians(80); // s_max in the paper
    private static final double OPENS = 1.15; // hysteresis: a closed direction opens at so many times the distance
    private static final double STEERING = 2.0; // 1/s; turn rate per angle that is missing
    private static final double TURN_FIRST = Math.toRadians(60); // no driving while so much is missing
    private static final double SLOWEST = 0.08; // m/s; slower than this it would never get through
    private static final double CLOSE_BY = Math.toRadians(75); // closed to each side by what is nearer than allowed
    private static final double COSTLY = 1e9;

    /// @param lookahead obstacles beyond this distance do not close a direction [m]
    /// @param safetyDistance room to keep beside the outline at standstill [m]
    /// @param safetyDistancePerSpeed more room per speed [m per m/s]
    /// @param sector angle between neighboring directions [rad]; the next that divides a turn
    public record Settings(
            double lookahead,
            double safetyDistance,
            double safetyDistancePerSpeed,
            double sector,
            Openings openings,
            Turning turning,
            Weights weights) {
        public static Settings of(double lookahead, double safetyDistance, double safetyDistancePerSpeed) {
            return new Settings(
                    lookahead,
                    safetyDistance,
                    safetyDistancePerSpeed,
                    Math.toRadians(5),
                    Openings.ANY_SPEED,
                    Turning.ANY_RATE,
                    Weights.DEFAULT);
        }
    }

    /// How fast to be at most in openings between obstacles [m/s].
    public record Openings(double narrow, double wide) {
        static final Openings ANY_SPEED = new Openings(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY);
    }

    /// How fast to turn at most, linear in between.
    ///
    /// @param standing at 0 m/s [rad/s]
    /// @param atSpeed at 1 m/s [rad/s]
    /// @param safety how many times wider curves are to be expected
    public record Turning(double standing, double atSpeed, double safety) {
        static final Turning ANY_RATE = new Turning(Double.POSITIVE_INFINITY, Double.POSITIVE_INFINITY, 1);

        double most(double speed) {
            double share = Math.min(1, Math.abs(speed));
            return share == 0 || standing == atSpeed ? standing : standing + share * (atSpeed - standing);
        }
    }

    /// What it costs to go elsewhere than to the target ("μ₁"), straight on ("μ₂") or as chosen before ("μ₃"). The
    /// first is more than the other two together, or a robot could pass by its target for ever.
    public record Weights(double target, double heading, double previous) {
        static final Weights DEFAULT = new Weights(5, 2, 2);

        /// @throws IllegalArgumentException when the first is not more than the other two, or one is negative
        public Weights {
            if (!(heading >= 0 && previous >= 0 && target > heading + previous)) {
                throw new IllegalArgumentException(
                        "Going to the target '%s' must weigh more than going straight on '%s' and keeping the choice '%s' together."
                                .formatted(target, heading, previous));
            }
        }
    }

    private final Settings settings;
    private final DriveLimits limits;
    private final VelocityFilter caution;
    private final double radius;
    private final double safetyDistance; // at standstill, as all of its body needs it [m]
    private final int sectors;
    private final double sector;
    private final double[] nearest;
    private final boolean[] closed; // by direction in the odometry frame, for hysteresis
    private final boolean[] masked;
    private double openingSpeed; // m/s
    private double previous = Double.NaN;
    private double bestCost;
    private double bestDirection;

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public Vfh(Footprint footprint, DriveLimits limits, Settings settings, double reaction) {
        this.settings = settings;
        this.limits = limits;
        this.radius = footprint.inscribedRadius();
        this.safetyDistance = VelocityFilter.room(footprint, settings.safetyDistance());
        this.caution = new VelocityFilter(footprint, limits, reaction);
        this.sectors = (int) Math.round(2 * Math.PI / settings.sector());
        this.sector = 2 * Math.PI / sectors;
        this.nearest = new double[sectors];
        this.closed = new boolean[sectors];
        this.masked = new boolean[sectors];
    }

    @Override
    public List<Point2d> predictedTrajectory() {
        return caution.predictedTrajectory();
    }

    @Override
    public void reset() {
        Arrays.fill(closed, false);
        previous = Double.NaN;
        caution.reset();
    }

    /// [Twist2d#STOP] when no direction is open.
    @Override
    public Twist2d drive(Obstacles obstacles, Target target, Motion motion) {
        double distance = target.distance();
        double heading = motion.odomFromBase().theta();
        fill(obstacles, Math.min(settings.lookahead(), distance), heading);
        mask(obstacles, heading, motion.velocity());
        if (!choose(Angles.wrap(heading + target.bearing()), heading)) {
            previous = Double.NaN;
            caution.stands();
            return Twist2d.STOP;
        }
        previous = bestDirection;
        double turn = Angles.difference(heading, bestDirection);
        double turnRate = turnRate(motion.velocity().vx());
        double omega = Math.clamp(STEERING * turn, -turnRate, turnRate);
        double straightness = Math.max(0, 1 - Math.abs(turn) / TURN_FIRST);
        double speed = Math.min(openingSpeed, speedBeside(obstacles, turn)) * straightness;
        if (target.arriving()) {
            speed = Math.min(speed, limits.arriving(distance));
        }
        Twist2d command = caution.guarded(Twist2d.drive(speed, omega), turn, motion.velocity(), obstacles);
        caution.arrivesAt(target);
        return command;
    }

    @Override
    public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
        return caution.turn(angle, motion.velocity(), obstacles);
    }

    @Override
    public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
        return caution.guarded(wanted, motion.velocity(), obstacles);
    }

    /// The primary histogram, made binary (sections 2.1 and 2.2): which directions lead to an obstacle, grown by the
    /// robot's radius and safety distance, before the target is reached.
    private void fill(Obstacles obstacles, double reach, double heading) {
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        double least = radius + safetyDistance;
        for (int i = 0; i < obstacles.count(); i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            double grown = least + obstacles.room(i);
            double distance = Math.hypot(x, y);
            double half = distance > grown ? Math.min(CLOSE_BY, Math.asin(grown / distance)) : CLOSE_BY;
            double direction = heading + Math.atan2(y, x);
            int first = (int) Math.ceil((direction - half) / sector);
            int last = (int) Math.floor((direction + half) / sector);
            for (int s = first; s <= last; s++) {
                int at = Math.floorMod(s, sectors);
                nearest[at] = Math.min(nearest[at], distance);
            }
        }
        // What the robot would only touch beyond the target does not matter, nor does it need hysteresis.
        boolean whole = reach == settings.lookahead();
        for (int s = 0; s < sectors; s++) {
            closed[s] = nearest[s] < radius + (closed[s] && whole ? reach * OPENS : reach);
        }
    }

    private double turnRate(double speed) {
        return Math.min(limits.turnRate(), settings.turning().most(speed));
    }

    /// Closes also the directions that the robot, at its speed, can only turn to through an obstacle (section 2.3).
    private void mask(Obstacles obstacles, double heading, Twist2d velocity) {
        System.arraycopy(closed, 0, masked, 0, sectors);
        double speed = Math.abs(velocity.vx());
        double turning = settings.turning().safety() * speed / turnRate(speed);
        double left = Math.PI; // how far it can turn to the left
        double right = Math.PI;
        for (int i = 0; i < obstacles.count() && turning > SLOWEST; i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            double fromCenter = Math.abs(y) - turning; // of the circle to the side where it is
            double grown = radius + safetyDistance + obstacles.room(i);
            boolean bars = x > 0 && x * x + fromCenter * fromCenter < (turning + grown) * (turning + grown);
            if (bars && y > 0) {
                left = Math.min(left, Math.atan2(y, x));
            } else if (bars && y < 0) {
                right = Math.min(right, -Math.atan2(y, x));
            }
        }
        for (int s = 0; s < sectors; s++) {
            double turn = Angles.difference(heading, s * sector);
            masked[s] |= turn > left || -turn > right;
        }
    }

    /// The candidate directions of the paper and the cheapest of them (section 2.4).
    private boolean choose(double target, double heading) {
        bestCost = COSTLY;
        int start = 0;
        while (start < sectors && !masked[start]) {
            start++;
        }
        if (start == sectors) {
            consider(target, target, heading, settings.openings().wide());
            return true;
        }
        int s = start;
        while (s < start + sectors) {
            if (masked[s % sectors]) {
                s++;
                continue;
            }
            int first = s;
            while (!masked[s % sectors]) {
                s++;
            }
            int last = s - 1;
            int size = last - first + 1;
            boolean wide = size * sector > WIDE;
            double most =
                    wide ? settings.openings().wide() : settings.openings().narrow();
            if (wide) {
                consider(first * sector + WIDE / 2, target, heading, most);
                consider(last * sector - WIDE / 2, target, heading, most);
            } else {
                consider((first + last) / 2.0 * sector, target, heading, most);
            }
            double fromFirst = Angles.wrap(target - first * sector);
            double into = fromFirst < 0 ? fromFirst + 2 * Math.PI : fromFirst;
            if (into <= (size - 1) * sector) {
                consider(target, target, heading, most);
            }
        }
        return bestCost < COSTLY;
    }

    private void consider(double direction, double target, double heading, double most) {
        double cost = settings.weights().target() * Math.abs(Angles.difference(direction, target))
                + settings.weights().heading() * Math.abs(Angles.difference(direction, heading));
        if (!Double.isNaN(previous)) {
            cost += settings.weights().previous() * Math.abs(Angles.difference(direction, previous));
        }
        if (cost < bestCost) {
            bestCost = cost;
            bestDirection = Angles.wrap(direction);
            openingSpeed = most;
        }
    }

    /// How fast the room beside the way and before the robot lets it go.
    private double speedBeside(Obstacles obstacles, double turn) {
        double cos = Math.cos(turn);
        double sin = Math.sin(turn);
        double speed = limits.speed();
        double wide = radius + safetyDistance + settings.safetyDistancePerSpeed() * speed;
        for (int i = 0; i < obstacles.count(); i++) {
            double ahead = cos * obstacles.x(i) + sin * obstacles.y(i);
            double beside = Math.abs(cos * obstacles.y(i) - sin * obstacles.x(i));
            if (ahead <= 0 || beside >= wide + obstacles.room(i)) {
                continue;
            }
            double room = beside - radius - safetyDistance - obstacles.room(i);
            double allowed = Math.max(SLOWEST, room / settings.safetyDistancePerSpeed());
            // What is farther ahead need not be obeyed before one is there.
            double gap = Math.max(0, ahead - radius);
            speed = Math.min(speed, Math.sqrt(allowed * allowed + limits.acceleration() * gap));
        }
        return speed;
    }
}
