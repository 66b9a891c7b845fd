package rsal.navigation.avoid;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.Deque;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.PriorityQueue;
import java.util.Set;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Footprint;
import rsal.data.Pose2d;
import rsal.data.Twist2d;

/// Finds how a robot turns where it has no room to turn in place: to and fro, straight and in arcs, as one turns a car
/// in three points. A search by A* (P. E. Hart, N. J. Nilsson, B. Raphael, A Formal Basis for the Heuristic
/// Determination of Minimum Cost Paths, 1968) over cells of place and heading, each with the first pose found in it, as
/// hybrid A* does it (D. Dolgov, S. Thrun, M. Montemerlo, J. Diebel, Practical Search Techniques in Path Planning for
/// Autonomous Driving, 2008). Its heuristic is only what the missing turn takes in place, as half a meter around the
/// robot is all that is searched.
///
/// Immutable; may be used by several threads.
public final class MultiPointTurn {
    private static final double STEP = 0.02; // m
    private static final double TURN_STEP = Math.toRadians(5);
    private static final double[] CURVATURES = {0, 1.5, -1.5, 4, -4}; // 1/m
    private static final double CELL = 0.015; // m
    private static final int HEADINGS = 144;
    private static final double AROUND = 0.5; // m
    private static final int MOST_POSES = 30_000;
    private static final double TURNING = 0.15; // m that turning by 1 rad is as dear as
    private static final double REVERSING = 0.2; // m, the same
    private static final double TURNED = Math.toRadians(10);
    private static final double MARGIN = 0.02; // m; it goes slowly, and what is around stands
    private static final double BEHIND = 0.02; // m more from what lies behind, as that is remembered, not seen
    private static final double BEYOND = 0.01; // m more than the guard lets through, as odometry and scans err

    private final FootprintOutline outline;
    private final double radius;
    private final CollisionMonitor guard;

    /// A piece of the way.
    ///
    /// @param meters driven, negative backward; 0 where it turns in place
    /// @param radians turned meanwhile, evenly
    public record Leg(double meters, double radians) {
        /// Along an arc, exactly.
        private Pose2d from(Pose2d pose) {
            double half = radians / 2;
            double chord = half == 0 ? meters : meters * Math.sin(half) / half;
            double heading = pose.theta() + half;
            return new Pose2d(
                    pose.x() + chord * Math.cos(heading), pose.y() + chord * Math.sin(heading), pose.theta() + radians);
        }

        private Leg half() {
            return new Leg(meters / 2, radians / 2);
        }

        private double cost() {
            return Math.abs(meters) + TURNING * Math.abs(radians);
        }

        private boolean reverses(Leg before) {
            return meters * before.meters < 0;
        }
    }

    /// @param reaction how long a command lasts before the next one can take effect [s]
    public MultiPointTurn(Footprint footprint, DriveLimits limits, double reaction) {
        this.outline = new FootprintOutline(footprint, 0);
        this.radius = footprint.circumscribedRadius();
        this.guard = new CollisionMonitor(footprint, limits, MARGIN, BEHIND, reaction);
    }

    /// What of a command is safe while shunting, slowly and with less room than on the way.
    public Twist2d guarded(Twist2d wanted, Twist2d velocity, Obstacles obstacles) {
        return guard.limit(wanted, velocity, obstacles);
    }

    private static final List<Leg> MOVES = moves();

    private static List<Leg> moves() {
        var moves = new ArrayList<Leg>();
        moves.add(new Leg(0, TURN_STEP));
        moves.add(new Leg(0, -TURN_STEP));
        for (double curvature : CURVATURES) {
            moves.add(new Leg(STEP, STEP * curvature));
            moves.add(new Leg(-STEP, -STEP * curvature));
        }
        return List.copyOf(moves);
    }

    private record Node(
            Pose2d pose,
            double cost,
            @Nullable Node before,
            @Nullable Leg by) {}

    /// The obstacles that count, and how near each may come.
    private record Around(double[] x, double[] y, double[] kept, double[] keptBehind, boolean strangers) {}

    /// A search for how to come to where the robot has turned by an angle, 10° more or less, and can go on straight. It
    /// knows the obstacles as they are now, and may be asked anywhere, once: for the legs, one after the other, or
    /// nothing when there is no way within half a meter. It takes some milliseconds, a tenth of a second when it
    /// is in vain.
    ///
    /// @param angle to turn by [rad]
    /// @param ahead how far it must be able to go on [m]
    public Supplier<Optional<List<Leg>>> search(Obstacles obstacles, double angle, double ahead) {
        Around around = gather(obstacles, ahead);
        return () -> find(around, angle, ahead);
    }

    private Optional<List<Leg>> find(Around around, double angle, double ahead) {
        var queue = new PriorityQueue<Node>(Comparator.comparingDouble(node ->
                node.cost() + TURNING * Math.max(0, missing(node.pose(), angle) - TURNED)));
        Set<Long> done = new HashSet<>();
        queue.add(new Node(Pose2d.ORIGIN, 0, null, null));
        while (!queue.isEmpty() && done.size() < MOST_POSES) {
            Node node = queue.poll();
            if (!done.add(cell(node.pose()))) {
                continue;
            }
            if (missing(node.pose(), angle) <= TURNED && isOpen(node.pose(), ahead, around)) {
                return Optional.of(legs(node));
            }
            for (Leg move : MOVES) {
                Pose2d next = move.from(node.pose());
                boolean blindly = move.meters() < 0 && around.strangers();
                if (!blindly
                        && Math.hypot(next.x(), next.y()) <= AROUND
                        && !done.contains(cell(next))
                        && isFree(move, node.pose(), next, around)) {
                    double reversing = node.by() != null && move.reverses(node.by()) ? REVERSING : 0;
                    queue.add(new Node(next, node.cost() + move.cost() + reversing, node, move));
                }
            }
        }
        return Optional.empty();
    }

    private static double missing(Pose2d pose, double angle) {
        return Math.abs(Angles.difference(pose.theta(), angle));
    }

    private static long cell(Pose2d pose) {
        long column = Math.round(pose.x() / CELL);
        long row = Math.round(pose.y() / CELL);
        long heading = Math.floorMod(Math.round(pose.theta() * HEADINGS / (2 * Math.PI)), (long) HEADINGS);
        return ((column << 20) ^ (row & 0xfffff)) * HEADINGS + heading;
    }

    /// What is nearer than its margin already may not come nearer.
    private Around gather(Obstacles obstacles, double ahead) {
        double reach = AROUND + radius + ahead + MARGIN;
        int count = 0;
        double[] x = new double[obstacles.count()];
        double[] y = new double[obstacles.count()];
        double[] kept = new double[obstacles.count()];
        double[] keptBehind = new double[obstacles.count()];
        boolean strangers = false;
        for (int i = 0; i < obstacles.count(); i++) {
            double px = obstacles.x(i);
            double py = obstacles.y(i);
            if (Math.hypot(px, py) <= reach + obstacles.room(i)) {
                double distance = outline.distance(px, py);
                x[count] = px;
                y[count] = py;
                kept[count] = kept(MARGIN + obstacles.room(i), distance);
                keptBehind[count] = kept(MARGIN + BEHIND + obstacles.room(i), distance);
                count++;
                strangers |= obstacles.room(i) > 0;
            }
        }
        return new Around(
                Arrays.copyOf(x, count),
                Arrays.copyOf(y, count),
                Arrays.copyOf(kept, count),
                Arrays.copyOf(keptBehind, count),
                strangers);
    }

    private static double kept(double margin, double distance) {
        return distance <= margin ? distance : Math.min(margin + BEYOND, (margin + distance) / 2);
    }

    private boolean isFree(Leg move, Pose2d from, Pose2d to, Around around) {
        boolean backward = move.meters() < 0;
        return isFree(to, backward, around) && isFree(move.half().from(from), backward, around);
    }

    private boolean isOpen(Pose2d pose, double ahead, Around around) {
        var straight = new Leg(STEP, 0);
        Pose2d next = pose;
        for (double way = 0; way < ahead; way += STEP) {
            next = straight.from(next);
            if (!isFree(next, false, around)) {
                return false;
            }
        }
        return true;
    }

    private boolean isFree(Pose2d pose, boolean backward, Around around) {
        double cos = Math.cos(pose.theta());
        double sin = Math.sin(pose.theta());
        for (int i = 0; i < around.x().length; i++) {
            double dx = around.x()[i] - pose.x();
            double dy = around.y()[i] - pose.y();
            double forward = cos * dx + sin * dy;
            double kept = backward && forward < 0 ? around.keptBehind()[i] : around.kept()[i];
            if (outline.distance(forward, cos * dy - sin * dx) < kept - 1e-9) {
                return false;
            }
        }
        return true;
    }

    /// Steps of one kind make one leg.
    private static List<Leg> legs(Node last) {
        Deque<Leg> moves = new ArrayDeque<>();
        for (Node node = last; node.by() != null && node.before() != null; node = node.before()) {
            moves.addFirst(node.by());
        }
        var legs = new ArrayList<Leg>();
        Leg before = null;
        for (Leg move : moves) {
            if (move.equals(before)) {
                Leg leg = legs.removeLast();
                legs.add(new Leg(leg.meters() + move.meters(), leg.radians() + move.radians()));
            } else {
                legs.add(new Leg(move.meters(), move.radians()));
            }
            before = move;
        }
        return List.copyOf(legs);
    }
}
