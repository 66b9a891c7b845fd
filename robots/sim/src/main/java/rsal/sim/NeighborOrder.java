package rsal.sim;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.function.Function;
import rsal.data.Pose2d;

/// Robots in the order in which their sensors look: along a Z-shaped curve through the plane (G. Morton, A Computer
/// Oriented Geodetic Data Base and a New Technique in File Sequencing, 1966). Those that come one after the other
/// are near each other, so that most of the walls and robots that one sees are still in the processor's cache when the
/// next looks. What they see does not depend on the order.
///
/// Robots move slowly, so an order is kept for a while.
///
/// @param <R> robots
final class NeighborOrder<R> {
    private static final double CELLS_PER_METER = 0.5;
    private static final int LASTS = 50; // looks
    private static final int MIDDLE = 1 << 15; // the cell of the origin, of 16 bits
    private static final int EVEN_BITS = 0x5555_5555;
    private static final int INDEX_BITS = 31;

    private final Function<R, Pose2d> mapFromRobot;
    private List<R> ordered = List.of();
    private int changes; // of the robots, when they were ordered
    private int left; // looks that the order lasts

    NeighborOrder(Function<R, Pose2d> mapFromRobot) {
        this.mapFromRobot = mapFromRobot;
    }

    /// @param now how often robots came or went until now
    List<R> order(List<R> robots, int now) {
        if (changes != now || left == 0) {
            ordered = ordered(robots);
            changes = now;
            left = LASTS;
        }
        left--;
        return ordered;
    }

    private List<R> ordered(List<R> robots) {
        long[] keys = new long[robots.size()];
        for (int i = 0; i < keys.length; i++) {
            keys[i] = place(mapFromRobot.apply(robots.get(i))) << INDEX_BITS | i;
        }
        Arrays.sort(keys);
        var sorted = new ArrayList<R>(keys.length);
        for (long key : keys) {
            sorted.add(robots.get((int) (key & Integer.MAX_VALUE)));
        }
        return List.copyOf(sorted);
    }

    /// Where on the curve a place is, a number of 32 bits: those of its column and of its row in turn.
    private static long place(Pose2d pose) {
        int column = cell(pose.x());
        int row = cell(pose.y());
        return Integer.toUnsignedLong(Integer.expand(column, EVEN_BITS) | Integer.expand(row, ~EVEN_BITS));
    }

    private static int cell(double meters) {
        return MIDDLE + (int) Math.clamp(Math.floor(meters * CELLS_PER_METER), -MIDDLE, MIDDLE - 1.0);
    }
}
