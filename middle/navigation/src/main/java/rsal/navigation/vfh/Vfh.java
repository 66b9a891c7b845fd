package rsal.navigation.vfh;

import java.util.Arrays;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Caution;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.LocalPlanner;
import rsal.navigation.avoid.Obstacles;

/// Chooses a direction by a polar histogram of obstacles: I. Ulrich, J. Borenstein, VFH+: Reliable Obstacle
/// Avoidance for Fast Mobile Robots (ICRA 1998), equations 1–19.
///
/// Differs from the paper in these points:
/// * The histogram is made of what the sensors see now, not of a certainty grid, and holds the nearest obstacle
///   per direction, not a sum, so that it does not depend on how many beams a scan has. The thresholds with
///   hysteresis are distances.
/// * Obstacles behind the target do not count.
/// * The safety distance grows with speed the other way round: directions are open as at standstill, and the room
///   beside the chosen one says how fast it may be taken.
/// * The last word has [Caution].
///
/// Keeps the last histogram and direction, so each robot needs its own.
public final class Vfh implements LocalPlanner {
    private static final int SECTORS = 72;
    private static final double SECTOR = 2 * Math.PI / SECTORS;
    private static final int WIDE = 16; // sectors; s_max in the paper
    private static final double TO_TARGET = 5; // μ₁
    private static final double TO_HEADING = 2; // μ₂
    private static final double TO_PREVIOUS = 2; // μ₃
    private static final double OPENS = 1.15; // hysteresis: a closed direction opens at so many times the distance
    private static final double STEERING = 2.0; // 1/s; turn rate per angle that is missing
    private static final double TURN_FIRST = Math.toRadians(60); // no driving while so much is missing
    private static final double SLOWEST = 0.08; // m/s; slower than this it would never get through
    private static final double CLOSE_BY = Math.toRadians(75); // closed to each side by what is nearer than allowed
    private static final double COSTLY = 1e9;

    /// @param lookahead obstacles beyond this distance do not close a direction [m]
    /// @param safetyDistance room to keep beside the outline at standstill [m]
    /// @param safetyDistancePerSpeed more room per speed [m per m/s]
    public record Settings(double lookahead, double safetyDistance, double safetyDistancePerSpeed) {}

    private final Settings settings;
    private final DriveLimits limits;
    private final Caution caution;
    private final double radius;
    private final double[] nearest = new double[SECTORS];
    private final boolean[] closed = new boolean[SECTORS]; // by direction in the odometry frame, for hysteresis
    private final boolean[] masked = new boolean[SECTORS];
    private double previous = Double.NaN;
    private double bestCost;
    private double bestDirection;

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public Vfh(Footprint footprint, DriveLimits limits, Settings settings, double reaction) {
        this.settings = settings;
        this.limits = limits;
        this.radius = footprint.inscribedRadius();
        this.caution = new Caution(footprint, limits, reaction);
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
            return Twist2d.STOP;
        }
        previous = bestDirection;
        double turn = Angles.difference(heading, bestDirection);
        double omega = Math.clamp(STEERING * turn, -limits.turnRate(), limits.turnRate());
        double straightness = Math.max(0, 1 - Math.abs(turn) / TURN_FIRST);
        double speed = Math.min(limits.speed(), speedBeside(obstacles, turn)) * straightness;
        if (target.arriving()) {
            speed = Math.min(speed, limits.arriving(distance));
        }
        return caution.guarded(Twist2d.drive(speed, omega), turn, motion.velocity(), obstacles);
    }

    @Override
    public Twist2d turn(Obstacles obstacles, double angle, Motion motion) {
        return caution.turn(angle, motion.velocity(), obstacles);
    }

    @Override
    public Twist2d guarded(Obstacles obstacles, Twist2d wanted, Motion motion) {
        return caution.guarded(wanted, motion.velocity(), obstacles);
    }

    /// The primary histogram, made binary: which directions lead to an obstacle, grown by the robot's radius and
    /// safety distance, before the target is reached.
    private void fill(Obstacles obstacles, double reach, double heading) {
        Arrays.fill(nearest, Double.POSITIVE_INFINITY);
        double least = radius + settings.safetyDistance();
        for (int i = 0; i < obstacles.count(); i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            double grown = least + obstacles.room(i);
            double distance = Math.hypot(x, y);
            double half = distance > grown ? Math.min(CLOSE_BY, Math.asin(grown / distance)) : CLOSE_BY;
            double direction = heading + Math.atan2(y, x);
            int first = (int) Math.ceil((direction - half) / SECTOR);
            int last = (int) Math.floor((direction + half) / SECTOR);
            for (int s = first; s <= last; s++) {
                int sector = Math.floorMod(s, SECTORS);
                nearest[sector] = Math.min(nearest[sector], distance);
            }
        }
        // What the robot would only touch beyond the target does not matter, nor does it need hysteresis.
        boolean whole = reach == settings.lookahead();
        for (int s = 0; s < SECTORS; s++) {
            closed[s] = nearest[s] < radius + (closed[s] && whole ? reach * OPENS : reach);
        }
    }

    /// Closes also the directions that the robot, at its speed, can only turn to through an obstacle.
    private void mask(Obstacles obstacles, double heading, Twist2d velocity) {
        System.arraycopy(closed, 0, masked, 0, SECTORS);
        double turning = Math.abs(velocity.vx()) / limits.turnRate();
        double left = Math.PI; // how far it can turn to the left
        double right = Math.PI;
        for (int i = 0; i < obstacles.count() && turning > SLOWEST; i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            double grown = radius + settings.safetyDistance() + obstacles.room(i);
            double angle = Math.atan2(y, x);
            if (x > 0 && y > 0 && Math.hypot(x, y - turning) < turning + grown) {
                left = Math.min(left, angle);
            }
            if (x > 0 && y < 0 && Math.hypot(x, y + turning) < turning + grown) {
                right = Math.min(right, -angle);
            }
        }
        for (int s = 0; s < SECTORS; s++) {
            double turn = Angles.difference(heading, s * SECTOR);
            masked[s] |= turn > left || -turn > right;
        }
    }

    /// The candidate directions of the paper and the cheapest of them.
    private boolean choose(double target, double heading) {
        bestCost = COSTLY;
        int start = 0;
        while (start < SECTORS && !masked[start]) {
            start++;
        }
        if (start == SECTORS) {
            consider(target, target, heading);
            return true;
        }
        int s = start;
        while (s < start + SECTORS) {
            if (masked[s % SECTORS]) {
                s++;
                continue;
            }
            int first = s;
            while (!masked[s % SECTORS]) {
                s++;
            }
            int last = s - 1;
            int size = last - first + 1;
            if (size <= WIDE) {
                consider((first + last) / 2.0 * SECTOR, target, heading);
            } else {
                consider((first + WIDE / 2) * SECTOR, target, heading);
                consider((last - WIDE / 2) * SECTOR, target, heading);
            }
            double fromFirst = Angles.wrap(target - first * SECTOR);
            double into = fromFirst < 0 ? fromFirst + 2 * Math.PI : fromFirst;
            if (into <= (size - 1) * SECTOR) {
                consider(target, target, heading);
            }
        }
        return bestCost < COSTLY;
    }

    private void consider(double direction, double target, double heading) {
        double cost = TO_TARGET * Math.abs(Angles.difference(direction, target))
                + TO_HEADING * Math.abs(Angles.difference(direction, heading));
        if (!Double.isNaN(previous)) {
            cost += TO_PREVIOUS * Math.abs(Angles.difference(direction, previous));
        }
        if (cost < bestCost) {
            bestCost = cost;
            bestDirection = Angles.wrap(direction);
        }
    }

    /// How fast the room beside the way and before the robot lets it go.
    private double speedBeside(Obstacles obstacles, double turn) {
        double cos = Math.cos(turn);
        double sin = Math.sin(turn);
        double speed = limits.speed();
        double wide = radius + settings.safetyDistance() + settings.safetyDistancePerSpeed() * speed;
        for (int i = 0; i < obstacles.count(); i++) {
            double ahead = cos * obstacles.x(i) + sin * obstacles.y(i);
            double beside = Math.abs(cos * obstacles.y(i) - sin * obstacles.x(i));
            if (ahead <= 0 || beside >= wide + obstacles.room(i)) {
                continue;
            }
            double room = beside - radius - settings.safetyDistance() - obstacles.room(i);
            double allowed = Math.max(SLOWEST, room / settings.safetyDistancePerSpeed());
            // What is farther ahead need not be obeyed before one is there.
            double gap = Math.max(0, ahead - radius);
            speed = Math.min(speed, Math.sqrt(allowed * allowed + limits.acceleration() * gap));
        }
        return speed;
    }
}
