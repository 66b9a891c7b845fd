package rsal.navigation.avoid;

import rsal.data.Footprint;
import rsal.data.Twist2d;

/// Lets no command through after which the robot could not stop without touching something: the robot's outline
/// is moved along the arc that the command and then braking lead to, and must stay clear of all obstacles. A
/// command that fails is made slower on the same arc, then reduced to its turn, then to a stop. After D. Fox, W.
/// Burgard, S. Thrun, The Dynamic Window Approach to Collision Avoidance (1997), whose admissible velocities
/// these are.
///
/// What is already nearer than the margin may not come any nearer. Backward, where robots see little, it goes only when
/// nothing that may move is beside or behind: of another robot it may see no more than a corner.
public final class CollisionMonitor {
    private static final double LONGEST_STEP = 0.05; // s
    private static final double LONGEST_DISTANCE = 0.04; // m per step
    private static final double[] SHARES = {1, 0.75, 0.5, 0.3, 0.15};
    private static final double HIDDEN = 0.4; // m; so large may be what is not seen of what may move
    private static final double REMEMBERED = 0.05; // m; what lies behind may be so much nearer than remembered
    private static final double AHEAD = 0.15; // m; what is seen there has little behind it that is not seen
    private static final double ROUNDING = 1e-3; // m; so much nearer is not "nearer"

    private final FootprintOutline outline;
    private final double radius;
    private final double step; // s
    private final DriveLimits limits;
    private final double margin;
    private final double behind;
    private final double reaction;
    private int near;
    private double[] nearX = new double[256];
    private double[] nearY = new double[256];
    private double[] nearMargin = new double[256];

    /// @param margin how near obstacles may come to the outline [m]
    /// @param reaction how long a command lasts before the next one can take effect [s]
    public CollisionMonitor(Footprint footprint, DriveLimits limits, double margin, double reaction) {
        this(footprint, limits, margin, REMEMBERED, reaction);
    }

    /// @param behind how much nearer yet what lies behind may not come [m]
    CollisionMonitor(Footprint footprint, DriveLimits limits, double margin, double behind, double reaction) {
        this.behind = behind;
        this.outline = new FootprintOutline(footprint, 0);
        this.step = Math.min(LONGEST_STEP, LONGEST_DISTANCE / limits.speed());
        this.radius = footprint.circumscribedRadius();
        this.limits = limits;
        this.margin = margin;
        this.reaction = reaction;
    }

    /// The wanted command or what of it is safe. Where numbers are not finite nothing is known to be safe: a stop.
    public Twist2d limit(Twist2d wanted, Twist2d velocity, Obstacles obstacles) {
        if (!wanted.isFinite() || !velocity.isFinite()) {
            return Twist2d.STOP;
        }
        gather(wanted, velocity, obstacles);
        if (wanted.vx() < 0 && mayHitWhatItDoesNotSee(obstacles)) {
            return turning(wanted, velocity);
        }
        for (double share : SHARES) {
            double forward = share * wanted.vx();
            double omega = share * wanted.omega();
            if (isSafe(forward, omega, velocity)) {
                return Twist2d.drive(forward, omega);
            }
        }
        return turning(wanted, velocity);
    }

    /// The turn alone if that is safe.
    private Twist2d turning(Twist2d wanted, Twist2d velocity) {
        return isSafe(0, wanted.omega(), velocity) ? Twist2d.drive(0, wanted.omega()) : Twist2d.STOP;
    }

    private boolean mayHitWhatItDoesNotSee(Obstacles obstacles) {
        for (int i = 0; i < obstacles.count(); i++) {
            double distance = Math.hypot(obstacles.x(i), obstacles.y(i));
            if (obstacles.room(i) > 0 && distance < radius + HIDDEN && obstacles.x(i) < AHEAD) {
                return true;
            }
        }
        return false;
    }

    /// The points that the robot could come to at all, each with the margin that it must keep.
    private void gather(Twist2d wanted, Twist2d velocity, Obstacles obstacles) {
        double speed = Math.max(Math.abs(wanted.vx()), Math.abs(velocity.vx()));
        double reach =
                radius + margin + behind + speed * (reaction + step) + speed * speed / (2 * limits.acceleration());
        near = 0;
        if (nearX.length < obstacles.count()) {
            nearX = new double[obstacles.count()];
            nearY = new double[obstacles.count()];
            nearMargin = new double[obstacles.count()];
        }
        for (int i = 0; i < obstacles.count(); i++) {
            double x = obstacles.x(i);
            double y = obstacles.y(i);
            double farthest = reach + obstacles.room(i);
            if (x * x + y * y <= farthest * farthest) {
                double kept = margin + obstacles.room(i) + (x < 0 && wanted.vx() < 0 ? behind : 0);
                nearX[near] = x;
                nearY[near] = y;
                nearMargin[near] = Math.min(kept, outline.distance(x, y) - ROUNDING);
                near++;
            }
        }
    }

    /// Follows a command for the reaction time and brakes then.
    private boolean isSafe(double forward, double omega, Twist2d velocity) {
        double v = velocity.vx();
        double w = velocity.omega();
        double x = 0;
        double y = 0;
        double theta = 0;
        double time = 0;
        while (time < reaction || Math.abs(v) > 1e-3 || Math.abs(w) > 1e-3) {
            boolean braking = time >= reaction;
            v = approach(v, braking ? 0 : forward, limits.acceleration() * step);
            w = approach(w, braking ? 0 : omega, limits.turnAcceleration() * step);
            double middle = theta + w * step / 2;
            x += v * step * Math.cos(middle);
            y += v * step * Math.sin(middle);
            theta += w * step;
            time += step;
            if (touches(x, y, theta)) {
                return false;
            }
        }
        return true;
    }

    private boolean touches(double x, double y, double theta) {
        double cos = Math.cos(theta);
        double sin = Math.sin(theta);
        for (int i = 0; i < near; i++) {
            double dx = nearX[i] - x;
            double dy = nearY[i] - y;
            if (outline.distance(cos * dx + sin * dy, cos * dy - sin * dx) < nearMargin[i]) {
                return true;
            }
        }
        return false;
    }

    private static double approach(double from, double to, double most) {
        return from + Math.clamp(to - from, -most, most);
    }
}
