package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// What two maps have in common when one is laid onto the other. It is asked for per area and not per beam: furniture
/// that stands in one room only is few beams, but all of it stands in what the other map saw as free floor. Rooms that
/// are alike in all that was seen of them can't be told apart by this.
///
/// @param squareMeters of floor that both saw
/// @param against share of what either hit within that floor, and the other saw through, 0 to 1
/// @param through share of the beams of either that go through what the other hit, 0 to 1
/// @param worst where most of what is against it stands; empty when nothing is
public record MapOverlap(double squareMeters, double against, double through, Optional<Clash> worst) {
    /// A place at which one hit something, and the other saw free floor.
    ///
    /// @param x of the middle of what was hit, in the map as it is when both are laid onto each other [m]
    /// @param y the same
    /// @param hitBy number of a scan that hit it; those of the second map follow on those of the first
    /// @param freeBy number of a scan of the other that saw through it
    public record Clash(double x, double y, int hitBy, int freeBy) {}

    private static final double LEAST_SQUARE_METERS = 2;

    // Rooms of a made-up building that were taken for each other, four pairs: 0.021 to 0.067. Maps that share a place:
    // 0.011 at most (parts, and alternate fours of scans, of four public logs, usual noise), though up to 0.28 of the
    // beams go through.
    public static final double MOST_AGAINST = 0.015;

    /// Who hit something within this of where the other did hit the same [m]. As right maps bend: with 0.3, fours of
    /// Seattle have 0.09 against.
    public static final double NEAR = 0.7;

    private static final double CELL = 0.1; // m
    private static final double SHORT = 0.3; // m; free floor ends so far before a hit
    private static final int NEAR_CELLS = (int) Math.round(NEAR / CELL);
    private static final int AROUND = 5; // cells to either side of a place at which what is against it is counted
    private static final int SEEN_BY = 2; // scans, so that who passed by is no wall

    /// Whether it can tell that they are of one place.
    boolean isEnough() {
        return squareMeters >= LEAST_SQUARE_METERS;
    }

    /// Whether so much speaks against it that they probably are of two places, or something was moved.
    public boolean isContradicted() {
        return against > MOST_AGAINST;
    }

    /// @param first number of the first frame of the second map; those below are the first's
    static MapOverlap of(List<GraphNode> frames, List<Pose2d> poses, int first) {
        Seen a = Seen.by(frames, poses, 0, first);
        Seen b = Seen.by(frames, poses, first, frames.size());
        long both = a.cells.entrySet().stream()
                .filter(e -> e.getValue().isFree() && b.isFree(e.getKey()))
                .count();
        Standing aInB = a.standingIn(b);
        Standing bInA = b.standingIn(a);
        var clashing = new HashMap<>(aInB.free());
        clashing.putAll(bInA.free()); // what both hit is in neither
        double against = clashing.size() / Math.max(1.0, clashing.size() + aInB.hit() + bInA.hit());
        int end = frames.size();
        var hitsOfA = new Transparency(LocalMap.of(frames, poses, 0, first - 1, 0));
        var hitsOfB = new Transparency(LocalMap.of(frames, poses, first, end - 1, first));
        Pose2d bFromMap = poses.get(first).inverse();
        Pose2d aFromMap = poses.getFirst().inverse();
        double through = (hitsOfB.through(frames.subList(0, first), poses.subList(0, first), bFromMap)
                        + hitsOfA.through(frames.subList(first, end), poses.subList(first, end), aFromMap))
                / 2;
        return new MapOverlap(both * CELL * CELL, against, through, worst(clashing));
    }

    /// In the middle of what stands around the cell that has most of it around.
    private static Optional<Clash> worst(Map<Long, Clash> clashing) {
        List<Clash> most = List.of();
        for (long cell : clashing.keySet().stream().sorted().toList()) {
            List<Clash> around = around(cell, clashing);
            most = around.size() > most.size() ? around : most;
        }
        if (most.isEmpty()) {
            return Optional.empty();
        }
        double x = most.stream().mapToDouble(Clash::x).average().orElseThrow();
        double y = most.stream().mapToDouble(Clash::y).average().orElseThrow();
        return most.stream()
                .min(Comparator.comparingDouble(c -> Math.hypot(c.x() - x, c.y() - y)))
                .map(c -> new Clash(x, y, c.hitBy(), c.freeBy()));
    }

    private static List<Clash> around(long cell, Map<Long, Clash> clashing) {
        var around = new ArrayList<Clash>();
        for (int dx = -AROUND; dx <= AROUND; dx++) {
            for (int dy = -AROUND; dy <= AROUND; dy++) {
                Clash clash = clashing.get(key(column(cell) + dx, row(cell) + dy));
                if (clash != null) {
                    around.add(clash);
                }
            }
        }
        return around;
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

    /// Where the cells are that one hit.
    ///
    /// @param hit how many of them stand in what the other hit, too
    /// @param free those that stand in what the other saw as free floor
    private record Standing(int hit, Map<Long, Clash> free) {}

    private record Seen(Map<Long, Times> cells) {
        static Seen by(List<GraphNode> frames, List<Pose2d> poses, int from, int to) {
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

        Standing standingIn(Seen other) {
            int hit = 0;
            var free = new HashMap<Long, Clash>();
            for (Map.Entry<Long, Times> entry : cells.entrySet()) {
                long cell = entry.getKey();
                if (!entry.getValue().isHit()) {
                    continue;
                }
                Times there = other.cells.get(cell);
                if (other.isHitNear(cell)) {
                    hit++;
                } else if (there != null && there.isFree()) {
                    double x = (column(cell) + 0.5) * CELL;
                    double y = (row(cell) + 0.5) * CELL;
                    free.put(cell, new Clash(x, y, entry.getValue().lastHit, there.lastFree));
                }
            }
            return new Standing(hit, free);
        }

        private boolean isHitNear(long cell) {
            for (int dx = -NEAR_CELLS; dx <= NEAR_CELLS; dx++) {
                for (int dy = -NEAR_CELLS; dy <= NEAR_CELLS; dy++) {
                    Times times = cells.get(key(column(cell) + dx, row(cell) + dy));
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

    private static int column(long cell) {
        return (int) (cell >> 32);
    }

    private static int row(long cell) {
        return (int) cell;
    }

    private static long key(int column, int row) {
        return ((long) column << 32) | (row & 0xffffffffL);
    }
}
