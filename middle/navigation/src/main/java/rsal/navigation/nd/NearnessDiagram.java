package rsal.navigation.nd;

import java.util.Arrays;
import java.util.Optional;
import rsal.data.Angles;
import rsal.navigation.avoid.Obstacles;

/// How near obstacles are in each direction, where that jumps by more than the robot's width (gaps), and the regions
/// between gaps that one could drive into: J. Minguez, L. Montano, Nearness Diagram (ND) Navigation: Collision
/// Avoidance in Troubled Scenarios (IEEE Transactions on Robotics and Automation 20, 2004), sections III–IV. A goal
/// that is seen and can be reached counts as a region of its own, even with no gap beside it: one before a wall.
///
/// Differs from the paper in that a place counts as reachable when no two obstacles to the left and to the right of
/// the straight way to it are nearer to each other than the robot is wide; the paper follows corridors in the
/// configuration space. Filled again for each step.
public final class NearnessDiagram {
    private static final int SECTORS = 240;
    private static final double SECTOR = 2 * Math.PI / SECTORS;
    private static final double BETWEEN_POINTS = 0.02; // m; half of how far apart points of the same wall may be

    private final double radius;
    private final double minGapWidth;
    private final double[] depth = new double[SECTORS]; // to the nearest obstacle; +∞ when there is none
    private final double[] leftX = new double[SECTORS]; // of what is beside a way, on its left
    private final double[] leftY = new double[SECTORS];
    private final double[] rightX = new double[SECTORS];
    private final double[] rightY = new double[SECTORS];

    /// A region to drive into.
    ///
    /// @param direction of the goal, if that is in it and can be reached, else of the gap that it begins at [rad]
    /// @param goal whether it is the goal's
    /// @param corner direction of the nearer side of its gap [rad]; that of the goal when it is the goal's
    /// @param cornerDistance [m]
    /// @param side where the region lies from there: 1 to the left, −1 to the right
    /// @param width of the region [rad]
    public record Region(double direction, boolean goal, double corner, double cornerDistance, int side, double width) {
        static Region ofGoal(double direction) {
            return new Region(direction, true, direction, Double.POSITIVE_INFINITY, 1, 0);
        }

        /// [rad]
        public double middle() {
            return Angles.wrap(corner + side * width / 2);
        }
    }

    /// @param radius of the robot [m]
    /// @param minGapWidth by how much nearness must jump [m]
    public NearnessDiagram(double radius, double minGapWidth) {
        this.radius = radius;
        this.minGapWidth = minGapWidth;
    }

    public void fill(Obstacles obstacles) {
        Arrays.fill(depth, Double.POSITIVE_INFINITY);
        for (int i = 0; i < obstacles.count(); i++) {
            double distance = Math.hypot(obstacles.x(i), obstacles.y(i));
            double direction = Math.atan2(obstacles.y(i), obstacles.x(i));
            double half = Math.atan2(BETWEEN_POINTS, distance);
            int first = (int) Math.round((direction - half) / SECTOR);
            int last = (int) Math.round((direction + half) / SECTOR);
            for (int s = first; s <= last; s++) {
                int sector = Math.floorMod(s, SECTORS);
                depth[sector] = Math.min(depth[sector], Math.max(0, distance - obstacles.room(i)));
            }
        }
    }

    private double depth(int sector) {
        return depth[Math.floorMod(sector, SECTORS)];
    }

    /// Whether there is a gap between a sector and the next one to its left.
    private boolean gapAfter(int sector) {
        double here = depth(sector);
        double next = depth(sector + 1);
        return (Double.isInfinite(here) != Double.isInfinite(next)) || Math.abs(here - next) > minGapWidth;
    }

    /// The goal's region, or else that whose gap is nearest to it; empty when there is none to drive into.
    ///
    /// @param goal its direction [rad]
    /// @param distance to it [m]
    public Optional<Region> region(double goal, double distance) {
        boolean seen = depth((int) Math.round(goal / SECTOR)) >= distance;
        if (seen && isReachable(goal, distance)) {
            return Optional.of(Region.ofGoal(goal));
        }
        int start = 0;
        while (start < SECTORS && !gapAfter(start - 1)) {
            start++;
        }
        Optional<Region> best = Optional.empty();
        double least = Double.POSITIVE_INFINITY;
        int first = start;
        while (first < start + SECTORS && start < SECTORS) {
            int last = first;
            while (!gapAfter(last)) {
                last++;
            }
            double width = (last - first + 1) * SECTOR;
            for (int side = 1; side >= -1; side -= 2) {
                int inner = side > 0 ? first : last;
                double corner = Angles.wrap((inner - side * 0.5) * SECTOR);
                double off = Math.abs(Angles.difference(goal, corner));
                boolean rising = depth(inner - side) < depth(inner);
                if (rising && off < least && isReachable(corner, beyond(inner, inner - side))) {
                    least = off;
                    best = Optional.of(new Region(corner, false, corner, depth(inner - side), side, width));
                }
            }
            first = last + 1;
        }
        return best;
    }

    /// Where one has come through a gap: between what is on its two sides [m].
    private double beyond(int inner, int outer) {
        double far = Math.min(depth(inner), depth(outer) + 4 * radius);
        return (depth(outer) + far) / 2;
    }

    /// Whether the robot fits through all that is beside the straight way to a place, at which it must have room.
    private boolean isReachable(double direction, double distance) {
        int left = 0;
        int right = 0;
        for (int s = 0; s < SECTORS; s++) {
            if (depth[s] > distance + 2 * radius) {
                continue;
            }
            double off = s * SECTOR - direction;
            double along = depth[s] * Math.cos(off);
            double beside = depth[s] * Math.sin(off);
            if (along < 0 || along >= distance || Math.abs(beside) > 2 * radius) {
                continue;
            }
            if (Math.hypot(along - distance, beside) < radius) {
                return false;
            }
            if (beside > 0) {
                leftX[left] = along;
                leftY[left] = beside;
                left++;
            } else {
                rightX[right] = along;
                rightY[right] = beside;
                right++;
            }
        }
        for (int i = 0; i < left; i++) {
            for (int j = 0; j < right; j++) {
                double dx = leftX[i] - rightX[j];
                double dy = leftY[i] - rightY[j];
                if (dx * dx + dy * dy < 4 * radius * radius) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Told of each direction in which something is.
    public interface Nearness {
        /// @param direction [rad]
        /// @param distance from the base [m]
        void in(double direction, double distance);
    }

    public void forEach(Nearness nearness) {
        for (int s = 0; s < SECTORS; s++) {
            if (depth[s] < Double.POSITIVE_INFINITY) {
                nearness.in(Angles.wrap(s * SECTOR), depth[s]);
            }
        }
    }
}
