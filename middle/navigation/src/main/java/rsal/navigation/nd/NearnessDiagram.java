package rsal.navigation.nd;

import java.util.Arrays;
import java.util.Optional;
import rsal.data.Angles;
import rsal.navigation.avoid.Obstacles;

/// How near obstacles are in each direction, where that jumps by more than the robot's width (gaps), and the regions
/// between gaps that one could drive into: J. Minguez, L. Montano, Nearness Diagram (ND) Navigation: Collision
/// Avoidance in Troubled Scenarios (IEEE Transactions on Robotics and Automation 20, 2004), sections III–IV.
///
/// Differs from the paper in that a region counts as passable when the corner that it begins at is wide enough from
/// all that bounds the region, not when a way through it is found. Filled anew for each step.
public final class NearnessDiagram {
    private static final int SECTORS = 240;
    private static final double SECTOR = 2 * Math.PI / SECTORS;
    private static final double BETWEEN_POINTS = 0.02; // m; half of how far apart points of the same wall may be

    private final double radius;
    private final double minGapWidth;
    private final double[] depth = new double[SECTORS]; // to the nearest obstacle; +∞ when there is none

    /// A region.
    ///
    /// @param corner direction of the nearer side of its rising gap, the one nearer to the goal [rad]
    /// @param cornerDistance [m]
    /// @param side where the region lies from there: 1 to the left, −1 to the right
    /// @param width of the region [rad]
    public record Region(double corner, double cornerDistance, int side, double width) {
        /// Whether a direction leads into it [rad].
        public boolean contains(double direction) {
            double into = side * Angles.difference(corner, direction);
            return (into < 0 ? into + 2 * Math.PI : into) <= width;
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

    /// The passable region whose rising gap is nearest to a direction [rad]; empty when there is none.
    public Optional<Region> region(double goal) {
        int start = 0;
        while (start < SECTORS && !gapAfter(start - 1)) {
            start++;
        }
        if (start == SECTORS) {
            boolean open = Double.isInfinite(depth[0]);
            return open
                    ? Optional.of(new Region(goal - Math.PI, Double.POSITIVE_INFINITY, 1, 2 * Math.PI))
                    : Optional.empty();
        }
        Optional<Region> best = Optional.empty();
        double least = Double.POSITIVE_INFINITY;
        int first = start;
        while (first < start + SECTORS) {
            int last = first;
            while (!gapAfter(last)) {
                last++;
            }
            for (Region region : sides(first, last)) {
                double off = region.contains(goal) ? 0 : Math.abs(Angles.difference(goal, region.corner()));
                off += 1e-3 * Math.abs(Angles.difference(goal, region.corner())); // the nearer side of the same region
                if (off < least && isPassable(first, last, region)) {
                    least = off;
                    best = Optional.of(region);
                }
            }
            first = last + 1;
        }
        return best;
    }

    /// The region seen from its right side and from its left, as far as those are rising gaps.
    private Region[] sides(int first, int last) {
        double width = (last - first + 1) * SECTOR;
        boolean fromRight = depth(first - 1) < depth(first);
        boolean fromLeft = depth(last + 1) < depth(last);
        var right = new Region(Angles.wrap((first - 0.5) * SECTOR), depth(first - 1), 1, width);
        var left = new Region(Angles.wrap((last + 0.5) * SECTOR), depth(last + 1), -1, width);
        return fromRight && fromLeft
                ? new Region[] {right, left}
                : fromRight ? new Region[] {right} : fromLeft ? new Region[] {left} : new Region[0];
    }

    /// Whether nothing is so near to the region's corner that the robot could not pass between.
    private boolean isPassable(int first, int last, Region region) {
        double x = region.cornerDistance() * Math.cos(region.corner());
        double y = region.cornerDistance() * Math.sin(region.corner());
        int from = region.side() > 0 ? first : last;
        for (int i = 0; i < SECTORS / 4; i++) {
            int sector = from + region.side() * i;
            double far = depth(sector);
            double direction = sector * SECTOR;
            if (Math.hypot(far * Math.cos(direction) - x, far * Math.sin(direction) - y) < 2 * radius) {
                return false;
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
