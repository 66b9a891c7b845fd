package rsal.navigation.slam;

import java.util.HashMap;
import java.util.List;
import java.util.Map;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// What two maps have in common when one is laid onto the other. It is asked for per area and not per beam: furniture
/// that stands in one room only is few beams, but all of it stands in what the other map saw as free floor. Rooms that
/// are alike in all that was seen of them can't be told apart by this.
///
/// @param squareMeters of floor that both saw
/// @param against share of what either hit within that floor, and the other saw through, 0 to 1
/// @param through share of the beams of either that go through what the other hit, 0 to 1
public record Shared(double squareMeters, double against, double through) {
    private static final double LEAST_SQUARE_METERS = 2;

    // Rooms of a made-up building that were taken for each other, four pairs: 0.021 to 0.067. Maps that share a place:
    // 0.011 at most (parts, and alternate fours of scans, of four public logs, usual noise), though up to 0.28 of the
    // beams go through.
    private static final double MOST_AGAINST = 0.015;

    private static final double CELL = 0.1; // m
    private static final double SHORT = 0.3; // m; free floor ends so far before a hit
    private static final int NEAR = 7; // cells, as right maps bend: with 3, fours of Seattle have 0.09 against
    private static final int SEEN_BY = 2; // scans, so that who passed by is no wall

    /// Whether they are of one place.
    boolean isEnough() {
        return squareMeters >= LEAST_SQUARE_METERS && against <= MOST_AGAINST;
    }

    /// @param first number of the first frame of the second map; those below are the first's
    static Shared of(List<Frame> frames, List<Pose2d> poses, int first) {
        Seen a = Seen.by(frames, poses, 0, first);
        Seen b = Seen.by(frames, poses, first, frames.size());
        long both = a.cells.entrySet().stream()
                .filter(e -> e.getValue().isFree() && b.isFree(e.getKey()))
                .count();
        int[] aInB = a.standingIn(b);
        int[] bInA = b.standingIn(a);
        double against = (aInB[0] + bInA[0]) / Math.max(1.0, aInB[0] + bInA[0] + aInB[1] + bInA[1]);
        int end = frames.size();
        var hitsOfA = new Transparency(Surroundings.of(frames, poses, 0, first - 1, 0));
        var hitsOfB = new Transparency(Surroundings.of(frames, poses, first, end - 1, first));
        Pose2d bFromMap = poses.get(first).inverse();
        Pose2d aFromMap = poses.getFirst().inverse();
        double through = (hitsOfB.through(frames.subList(0, first), poses.subList(0, first), bFromMap)
                        + hitsOfA.through(frames.subList(first, end), poses.subList(first, end), aFromMap))
                / 2;
        return new Shared(both * CELL * CELL, against, through);
    }

    /// How many scans saw a cell free, or hit something in it.
    private static final class Times {
        private int free;
        private int hit;
        private int lastFree = -1;
        private int lastHit = -1;

        boolean isFree() {
            return free >= SEEN_BY && hit == 0;
        }

        boolean isHit() {
            return hit >= SEEN_BY && hit >= free;
        }
    }

    private record Seen(Map<Long, Times> cells) {
        static Seen by(List<Frame> frames, List<Pose2d> poses, int from, int to) {
            var cells = new HashMap<Long, Times>();
            for (int i = from; i < to; i++) {
                Cloud cloud = frames.get(i).cloud().movedBy(poses.get(i));
                Pose2d eye = poses.get(i).compose(frames.get(i).scan().baseFromLaser());
                for (int point = 0; point < cloud.count(); point++) {
                    look(cells, i, eye, cloud.x(point), cloud.y(point));
                }
            }
            return new Seen(cells);
        }

        private static void look(Map<Long, Times> cells, int scan, Pose2d eye, double x, double y) {
            Times end = cells.computeIfAbsent(cell(x, y), _ -> new Times());
            if (end.lastHit != scan) {
                end.lastHit = scan;
                end.hit++;
            }
            double length = Math.hypot(x - eye.x(), y - eye.y());
            for (double along = 0; along < length - SHORT; along += CELL) {
                Times way = cells.computeIfAbsent(
                        cell(eye.x() + along / length * (x - eye.x()), eye.y() + along / length * (y - eye.y())),
                        _ -> new Times());
                if (way.lastFree != scan) {
                    way.lastFree = scan;
                    way.free++;
                }
            }
        }

        boolean isFree(long cell) {
            Times times = cells.get(cell);
            return times != null && times.isFree();
        }

        /// How many of the cells that it hit stand in what the other saw as free floor, and how many in what it hit,
        /// too.
        int[] standingIn(Seen other) {
            var counts = new int[2];
            cells.forEach((cell, times) -> {
                if (times.isHit()) {
                    if (other.isHitNear(cell)) {
                        counts[1]++;
                    } else if (other.isFree(cell)) {
                        counts[0]++;
                    }
                }
            });
            return counts;
        }

        private boolean isHitNear(long cell) {
            for (int dx = -NEAR; dx <= NEAR; dx++) {
                for (int dy = -NEAR; dy <= NEAR; dy++) {
                    Times times = cells.get(key((int) (cell >> 32) + dx, (int) cell + dy));
                    if (times != null && times.hit > 0) {
                        return true;
                    }
                }
            }
            return false;
        }
    }

    private static long cell(double x, double y) {
        return key((int) Math.floor(x / CELL), (int) Math.floor(y / CELL));
    }

    private static long key(int column, int row) {
        return ((long) column << 32) | (row & 0xffffffffL);
    }
}
