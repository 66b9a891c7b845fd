package rsal.navigation.slam;

import java.util.ArrayList;
import java.util.Collections;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// Where scans of a map contradict each other most: beams of some go through what others saw as a wall. Parts of a
/// place that were laid onto each other do that, whether or not the graph is bent there: a robot that was carried and
/// goes on as if it stood where it was taken bends nothing.
///
/// A wall is a cell in which at least three scans have hit something that lies on a line; a beam goes through it
/// when it meets it at more than 30°, ends well behind it, and no scan just before or after has hit it. So neither
/// people, of whom a scan or two have been in the way, nor beams along walls, of which a map that is a little off makes
/// many, nor glass and legs of chairs, which some beams hit and others don't, count for much.
///
/// @param share of the beams of the scans from one to another that go through walls, 0 to 1
/// @param from number of the first of these frames
/// @param to number of the last
public record FreeSpaceViolation(double share, int from, int to) {
    /// From which share on a map is probably wrong. In maps of logs that are right (seven with usual odometry,
    /// four of them with twice its noise, too) it is 0.11 at most; where made-up robots had been carried it is
    /// 0.31 and more.
    public static final double TOO_MUCH = 0.2;

    private static final int RUN = 20; // frames: 10 m of way, or less where it turns
    private static final int FEWEST = 10; // frames, to tell anything
    private static final int SEEN_BY = 3;
    private static final int AROUND = 10; // frames before and after one, that see what it sees
    private static final double CELL = 0.1; // m
    private static final double SHORT = 0.3; // m; of the beam's start
    private static final double BEYOND = 0.6; // m
    private static final double ACROSS = -0.5; // cosine of twice the angle between beam and normal, here 60°
    private static final int BEAMS = 90; // followed, of a scan

    /// Whether that is so much that the map is probably wrong there.
    public boolean isTooMuch() {
        return share > TOO_MUCH;
    }

    /// Empty when there are too few scans to tell.
    static Optional<FreeSpaceViolation> of(List<GraphNode> frames, List<Pose2d> poses) {
        if (frames.size() < FEWEST) {
            return Optional.empty();
        }
        var clouds = new ArrayList<Cloud>();
        for (int i = 0; i < frames.size(); i++) {
            clouds.add(frames.get(i).cloud().movedBy(poses.get(i)));
        }
        Map<Long, Wall> walls = walls(clouds);
        var through = new double[frames.size()];
        for (int i = 0; i < through.length; i++) {
            Pose2d eye = poses.get(i).compose(frames.get(i).scan().baseFromLaser());
            through[i] = through(walls, i, clouds.get(i), eye);
        }
        return Optional.of(worst(through, Math.min(RUN, through.length)));
    }

    private static FreeSpaceViolation worst(double[] through, int run) {
        double sum = 0;
        double most = -1;
        int last = 0;
        for (int i = 0; i < through.length; i++) {
            sum += through[i] - (i < run ? 0 : through[i - run]);
            if (i >= run - 1 && sum > most) {
                most = sum;
                last = i;
            }
        }
        return new FreeSpaceViolation(Math.max(0, most) / run, last - run + 1, last);
    }

    /// What was hit in a cell, and in which direction it faces: the sums of cosine and sine of twice the angle, so that
    /// both sides of a wall are the same.
    private static final class Wall {
        private final List<Integer> scans = new ArrayList<>(); // ascending
        private double cos;
        private double sin;

        void hit(int scan, double normalX, double normalY) {
            if (scans.isEmpty() || scans.getLast() != scan) {
                scans.add(scan);
            }
            cos += normalX * normalX - normalY * normalY;
            sin += 2 * normalX * normalY;
        }

        boolean isSeenAround(int scan) {
            int place = Collections.binarySearch(scans, scan - AROUND);
            int next = place < 0 ? -place - 1 : place;
            return next < scans.size() && scans.get(next) <= scan + AROUND;
        }

        /// @param twiceCos cosine of twice the direction of a beam
        boolean isAcross(double twiceCos, double twiceSin) {
            return cos * twiceCos + sin * twiceSin >= ACROSS * Math.hypot(cos, sin);
        }
    }

    private static Map<Long, Wall> walls(List<Cloud> clouds) {
        var walls = new HashMap<Long, Wall>();
        for (int i = 0; i < clouds.size(); i++) {
            Cloud cloud = clouds.get(i);
            for (int point = 0; point < cloud.count(); point++) {
                double x = cloud.normalX(point);
                double y = cloud.normalY(point);
                if (Double.isNaN(x)) {
                    continue;
                }
                walls.computeIfAbsent(cell(cloud.x(point), cloud.y(point)), _ -> new Wall())
                        .hit(i, x, y);
            }
        }
        walls.values().removeIf(wall -> wall.scans.size() < SEEN_BY);
        return walls;
    }

    private static long cell(double x, double y) {
        return ((long) Math.floor(x / CELL) << 32) ^ ((long) Math.floor(y / CELL) & 0xffffffffL);
    }

    /// Share of a scan's beams that go through walls.
    private static double through(Map<Long, Wall> walls, int scan, Cloud cloud, Pose2d eye) {
        int each = Math.max(1, cloud.count() / BEAMS);
        int followed = 0;
        int through = 0;
        for (int point = 0; point < cloud.count(); point += each) {
            followed++;
            through += isThrough(walls, scan, eye, cloud.x(point) - eye.x(), cloud.y(point) - eye.y()) ? 1 : 0;
        }
        return (double) through / Math.max(1, followed);
    }

    private static boolean isThrough(Map<Long, Wall> walls, int scan, Pose2d eye, double dx, double dy) {
        double length = Math.hypot(dx, dy);
        double cos = (dx * dx - dy * dy) / (length * length);
        double sin = 2 * dx * dy / (length * length);
        for (double along = SHORT; along < length - BEYOND; along += CELL / 2) {
            Wall wall = walls.get(cell(eye.x() + along / length * dx, eye.y() + along / length * dy));
            if (wall != null && wall.isAcross(cos, sin) && !wall.isSeenAround(scan)) {
                return true;
            }
        }
        return false;
    }
}
