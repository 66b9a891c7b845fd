package rsal.navigation.avoid;

import rsal.data.Angles;
import rsal.data.Twist2d;
import rsal.navigation.avoid.Controller.Motion;

/// Lets no command through that leads into the path of what moves, as far as [Movers] predicts it. A command that does
/// is made slower, then becomes a stop. Where even who stands would be run over, the robot gets out of the way: into
/// the
/// direction in which it keeps the most room (of the velocity obstacles of P. Fiorini, Z. Shiller, Motion Planning in
/// Dynamic Environments Using Velocity Obstacles, 1998, in that both go on as they do, and those who come are avoided
/// within a time horizon).
///
/// Differs in that the robot turns before it drives, as it cannot move sideways, and in that it counts on nobody to
/// avoid
/// it. The horizon grows with the speed of who comes. Of slow ones, such as robots, controllers keep clear themselves;
/// among those the robot waits for who comes from its right, and for nobody else. Each robot needs its own.
public final class Yielding {
    private static final double STEP = 0.1; // s
    private static final double SHORTEST = 0.6; // s
    private static final double PER_SPEED = 2.0; // s per m/s
    private static final double LONGEST = 3.5; // s
    private static final double ROOM = 0.2; // m between bodies
    private static final double STEERING = 2.0; // 1/s
    private static final double BACK = 0.2; // m/s
    private static final int DIRECTIONS = 8;
    private static final double KEPT = 0.05; // m of room that another direction must have more
    private static final double ROBOT =
            0.7; // m/s; slower ones keep clear of each other, and who comes from the left waits
    private static final double[] SHARES = {1, 0.5, 0};

    private final DriveLimits limits;
    private final double radius;
    private double evading = Double.NaN; // direction in the odometry frame

    /// @param radius of the circle that the robot turns in [m]
    public Yielding(DriveLimits limits, double radius) {
        this.limits = limits;
        this.radius = radius;
    }

    /// What of a command is safe from who moves.
    ///
    /// @param controller checks what this commands instead
    public Twist2d yielding(Twist2d wanted, Movers movers, Obstacles obstacles, Motion motion, Controller controller) {
        if (movers.count() == 0) {
            evading = Double.NaN;
            return wanted;
        }
        double standing = room(movers, 0, 0);
        for (double share : SHARES) {
            double room = share == 0 ? standing : room(movers, share * wanted.vx(), share * wanted.omega());
            if (room >= ROOM) {
                evading = Double.NaN;
                return Twist2d.drive(
                        share * wanted.vx(), share == 0 && wanted.vx() == 0 ? wanted.omega() : share * wanted.omega());
            }
        }
        return evade(standing, movers, obstacles, motion, controller);
    }

    private Twist2d evade(double standing, Movers movers, Obstacles obstacles, Motion motion, Controller controller) {
        double heading = motion.odomFromBase().theta();
        Twist2d best = Twist2d.STOP;
        double most = standing;
        double direction = Double.NaN;
        for (int i = 0; i <= DIRECTIONS; i++) {
            boolean isBack = i == DIRECTIONS;
            double turn = Angles.wrap(i * 2 * Math.PI / DIRECTIONS - heading);
            if (!isBack && !Double.isNaN(evading)) {
                turn = Angles.wrap(evading + i * 2 * Math.PI / DIRECTIONS - heading);
            }
            Twist2d first = isBack ? Twist2d.drive(-Math.min(BACK, limits.speed()), 0) : towards(turn);
            double room = isBack ? room(movers, first.vx(), 0) : roomTowards(movers, turn);
            boolean isKept = i == 0 && !Double.isNaN(evading);
            if (room + (isKept ? KEPT : 0) > most) {
                Twist2d safe = controller.guarded(obstacles, first, motion);
                boolean moves = Math.abs(safe.vx()) > Math.abs(first.vx()) / 2
                        || (Math.abs(first.vx()) < limits.speed() / 4 && safe.omega() != 0);
                if (moves) {
                    most = room + (isKept ? KEPT : 0);
                    best = safe;
                    direction = isBack ? Double.NaN : Angles.wrap(heading + turn);
                }
            }
        }
        evading = direction;
        return best;
    }

    private Twist2d towards(double turn) {
        double omega = Math.clamp(STEERING * turn, -limits.turnRate(), limits.turnRate());
        double straight = Math.max(0, 1 - Math.abs(turn) / (Math.PI / 2));
        return Twist2d.drive(limits.speed() * straight, omega);
    }

    /// Least distance between the robot, which follows an arc, and who moves, within the horizon [m].
    private double room(Movers movers, double v, double omega) {
        double least = Double.POSITIVE_INFINITY;
        double x = 0;
        double y = 0;
        double theta = 0;
        for (double time = 0; time <= LONGEST; time += STEP) {
            least = Math.min(least, roomAt(movers, time, x, y));
            x += v * STEP * Math.cos(theta + omega * STEP / 2);
            y += v * STEP * Math.sin(theta + omega * STEP / 2);
            theta += omega * STEP;
        }
        return least;
    }

    private double roomTowards(Movers movers, double turn) {
        double least = Double.POSITIVE_INFINITY;
        double x = 0;
        double y = 0;
        double theta = 0;
        for (double time = 0; time <= LONGEST; time += STEP) {
            least = Math.min(least, roomAt(movers, time, x, y));
            Twist2d now = towards(turn - theta);
            theta += now.omega() * STEP;
            x += now.vx() * STEP * Math.cos(theta);
            y += now.vx() * STEP * Math.sin(theta);
        }
        return least;
    }

    private double roomAt(Movers movers, double time, double x, double y) {
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < movers.count(); i++) {
            double speed = movers.speed(i);
            boolean isNear = time <= Math.min(LONGEST, SHORTEST + PER_SPEED * speed);
            boolean counts = speed > ROBOT || (movers.y(i) < 0 && movers.vy(i) > 0);
            if (isNear && counts && movers.isComing(i)) {
                double dx = movers.x(i) + movers.vx(i) * time - x;
                double dy = movers.y(i) + movers.vy(i) * time - y;
                least = Math.min(least, Math.hypot(dx, dy) - radius - movers.radius(i));
            }
        }
        return least;
    }

    /// Forgets what it did.
    public void reset() {
        evading = Double.NaN;
    }
}
