package rsal.navigation.amcl;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;

/// Where on the whole map a scan could have been taken: tries poses on a grid against a coarse likelihood field,
/// sorts the best of each neighborhood by how well walls hide what is behind them, climbs from the best of those in
/// the sharp field, and sorts again.
///
/// A particle filter that starts from such places needs far fewer particles than one that starts from uniform
/// ones; the idea of drawing particles from the sensor is S. Lenser, M. Veloso, Sensor Resetting Localization for
/// Poorly Modelled Mobile Robots (ICRA 2000). That a likelihood field alone sees through walls, which clutter makes
/// worse, is why walls are looked at early.
///
/// Not safe for several threads at once.
final class GlobalSearch {
    static final double STEP = 0.3; // m
    private static final int HEADINGS = 72;
    private static final int COARSE_BEAMS = 32;
    private static final int STEPS_PER_BIN = 3; // in each direction; the best of a bin is looked at
    private static final int HEADINGS_PER_BIN = 3;
    private static final int LOOKED_AT = 6000;
    private static final int CLIMBERS = 300;
    private static final double CLEARANCE = 0.15; // m; no robot stands closer to a wall
    private static final double ALL_BEAMS = 1e6;
    private static final double COARSE_DEVIATION = 0.3; // m, of what the coarse steps miss

    /// @param score mean logarithm of the likelihood of a beam; 0 is a perfect match
    record Candidate(double score, Pose2d mapFromBase) {}

    private static final Covariance2d ABOUT_HERE = Covariance2d.ofDeviations(0.5, 0.5, 0.3);

    private final LocalizationMap map;
    private final Refinement blurred;
    private final Refinement sharp;

    GlobalSearch(LocalizationMap map) {
        this.map = map;
        this.blurred = new Refinement(map.toFace, Math.max(map.deviation, COARSE_DEVIATION), ALL_BEAMS);
        this.sharp = new Refinement(map.toFace, map.deviation, ALL_BEAMS);
    }

    /// The best places, best first, none of them near a better one; none on a map that is too large to be searched.
    List<Candidate> candidates(Beams beams, int limit) {
        if (!map.isSearchable()) {
            return List.of();
        }
        Beams thin = thin(beams);
        List<Candidate> found = coarse(thin).stream()
                .map(c -> new Candidate(score(thin, c.mapFromBase(), COARSE_DEVIATION), c.mapFromBase()))
                .sorted(Comparator.comparingDouble(Candidate::score).reversed())
                .limit(CLIMBERS)
                .map(c -> better(beams, climb(beams, c.mapFromBase()), slide(beams, c.mapFromBase())))
                .sorted(Comparator.comparingDouble(Candidate::score).reversed())
                .toList();
        var best = new ArrayList<Candidate>();
        for (Candidate candidate : found) {
            if (best.size() == limit) {
                break;
            }
            if (best.stream().noneMatch(b -> b.mapFromBase().isNear(candidate.mapFromBase(), STEP, 0.2))) {
                best.add(candidate);
            }
        }
        return best;
    }

    /// How well a scan fits a place, when walls hide what is behind them.
    double score(Beams beams, Pose2d mapFromBase) {
        return score(beams, mapFromBase, map.deviation);
    }

    private double score(Beams beams, Pose2d mapFromBase, double deviation) {
        double cos = Math.cos(mapFromBase.theta());
        double sin = Math.sin(mapFromBase.theta());
        double sum = 0;
        for (int i = 0; i < beams.count(); i++) {
            sum += switch (verdict(beams, i, mapFromBase, cos, sin, deviation)) {
                case HIT -> log(beams, i, mapFromBase, cos, sin, deviation);
                case SHORT, OUTSIDE -> map.walls.unlikely();
                case THROUGH -> 2 * map.walls.unlikely();
            };
        }
        return beams.count() == 0 ? map.walls.unlikely() : sum / beams.count();
    }

    /// What became of a beam.
    enum Verdict {
        /// It ended at a wall of the map.
        HIT,
        /// It ended before one.
        SHORT,
        /// It ended behind one, or began outside the map.
        THROUGH,
        /// It left the map without meeting one, so that nobody knows.
        OUTSIDE
    }

    /// What became of the beams of a scan; what left the map says nothing.
    record Fates(int hits, int through, int shorter) {
        int reported() {
            return hits + through + shorter;
        }
    }

    Fates fates(Beams beams, Pose2d mapFromBase) {
        double cos = Math.cos(mapFromBase.theta());
        double sin = Math.sin(mapFromBase.theta());
        int hits = 0;
        int through = 0;
        int shorter = 0;
        for (int i = 0; i < beams.count(); i++) {
            switch (verdict(beams, i, mapFromBase, cos, sin)) {
                case HIT -> hits++;
                case THROUGH -> through++;
                case SHORT -> shorter++;
                case OUTSIDE -> {}
            }
        }
        return new Fates(hits, through, shorter);
    }

    /// @param cos of the heading
    /// @param sin the same
    Verdict verdict(Beams beams, int beam, Pose2d mapFromBase, double cos, double sin) {
        return verdict(beams, beam, mapFromBase, cos, sin, map.deviation);
    }

    private Verdict verdict(Beams beams, int beam, Pose2d mapFromBase, double cos, double sin, double deviation) {
        double fromX = mapFromBase.x() + cos * beams.originX()[beam] - sin * beams.originY()[beam];
        double fromY = mapFromBase.y() + sin * beams.originX()[beam] + cos * beams.originY()[beam];
        double toX = mapFromBase.x() + cos * beams.x()[beam] - sin * beams.y()[beam];
        double toY = mapFromBase.y() + sin * beams.x()[beam] + cos * beams.y()[beam];
        double measured = Math.sqrt((toX - fromX) * (toX - fromX) + (toY - fromY) * (toY - fromY));
        double through = measured - 4 * deviation;
        boolean isOnMap = map.toOccupied.contains(toX, toY);
        double looked = isOnMap ? through : measured; // steps are short near the wall at which a beam ends
        double wall = map.toOccupied.firstHit(
                fromX, fromY, (toX - fromX) / measured, (toY - fromY) / measured, Math.max(0, looked));
        if (wall < through) {
            return Verdict.THROUGH;
        }
        if (isOnMap) {
            return map.toOccupied.at(toX, toY) <= 3 * deviation ? Verdict.HIT : Verdict.SHORT;
        }
        return wall < measured ? Verdict.SHORT : Verdict.OUTSIDE;
    }

    private double log(Beams beams, int beam, Pose2d mapFromBase, double cos, double sin, double deviation) {
        double toX = mapFromBase.x() + cos * beams.x()[beam] - sin * beams.y()[beam];
        double toY = mapFromBase.y() + sin * beams.x()[beam] + cos * beams.y()[beam];
        return (deviation == map.deviation ? map.walls : map.nearWalls).log(toX, toY);
    }

    /// The best pose of each bin of poses, and of these the best ones.
    List<Candidate> coarse(Beams beams) {
        OccupancyGrid grid = map.grid;
        int stride = map.searchStep();
        int columns = Math.ceilDiv(grid.width(), stride);
        int rows = Math.ceilDiv(grid.height(), stride);
        int binColumns = Math.ceilDiv(columns, STEPS_PER_BIN);
        int binRows = Math.ceilDiv(rows, STEPS_PER_BIN);
        int perHeading = binColumns * binRows;
        int binHeadings = HEADINGS / HEADINGS_PER_BIN;
        var bestOfBin = new float[Math.multiplyExact(perHeading, binHeadings)];
        var poseOfBin = new int[bestOfBin.length];
        Arrays.fill(bestOfBin, Float.NEGATIVE_INFINITY);
        double toCoarse = 1 / map.coarseResolution;
        var places = new Places(columns, rows, stride);
        StridedField.Scan scan = map.nearWallsByStep().new Scan(places.x, places.y, beams.count());
        var turnedX = new float[beams.count()];
        var turnedY = new float[beams.count()];
        var sums = new float[columns];
        for (int heading = 0; heading < HEADINGS; heading++) {
            double theta = heading * 2 * Math.PI / HEADINGS;
            double cos = Math.cos(theta) * toCoarse;
            double sin = Math.sin(theta) * toCoarse;
            for (int i = 0; i < beams.count(); i++) {
                turnedX[i] = (float) (cos * beams.x()[i] - sin * beams.y()[i]);
                turnedY[i] = (float) (sin * beams.x()[i] + cos * beams.y()[i]);
            }
            scan.turn(turnedX, turnedY);
            int headingBin = heading / HEADINGS_PER_BIN * perHeading;
            for (int row = 0; row < rows; row++) {
                scan.sum(row, places.first[row], places.end[row], sums);
                int rowBin = headingBin + row / STEPS_PER_BIN * binColumns;
                for (int column = places.first[row]; column < places.end[row]; column++) {
                    int bin = rowBin + column / STEPS_PER_BIN;
                    if (sums[column] > bestOfBin[bin] && places.mayStand[row * columns + column]) {
                        bestOfBin[bin] = sums[column];
                        poseOfBin[bin] = (heading * rows + row) * columns + column;
                    }
                }
            }
        }
        float least = least(bestOfBin);
        var best = new ArrayList<Candidate>();
        for (int bin = 0; bin < bestOfBin.length; bin++) {
            if (bestOfBin[bin] >= least && bestOfBin[bin] > Float.NEGATIVE_INFINITY) {
                int column = poseOfBin[bin] % columns;
                int row = poseOfBin[bin] / columns % rows;
                int heading = poseOfBin[bin] / columns / rows;
                best.add(new Candidate(
                        bestOfBin[bin],
                        new Pose2d(
                                grid.x(at(column, stride, grid.width())),
                                grid.y(at(row, stride, grid.height())),
                                Angles.wrap(heading * 2 * Math.PI / HEADINGS))));
            }
        }
        return best;
    }

    /// The grid of places that are tried.
    private final class Places {
        private final float[] x; // by column, in cells of the coarse map
        private final float[] y; // by row
        private final boolean[] mayStand; // row by row
        private final int[] first; // by row: between which columns a robot may stand
        private final int[] end;

        Places(int columns, int rows, int stride) {
            OccupancyGrid grid = map.grid;
            x = inCoarseCells(columns, stride, grid.width());
            y = inCoarseCells(rows, stride, grid.height());
            mayStand = new boolean[columns * rows];
            first = new int[rows];
            end = new int[rows];
            for (int row = 0; row < rows; row++) {
                for (int column = 0; column < columns; column++) {
                    int cell = at(row, stride, grid.height()) * grid.width() + at(column, stride, grid.width());
                    if (grid.cells()[cell] == OccupancyGrid.FREE && !(map.toOccupied.at(cell) < CLEARANCE)) {
                        mayStand[row * columns + column] = true;
                        first[row] = end[row] == 0 ? column : first[row];
                        end[row] = column + 1;
                    }
                }
            }
        }

        private float[] inCoarseCells(int count, int stride, int size) {
            double toCoarse = 1 / map.coarseResolution;
            var places = new float[count];
            for (int i = 0; i < count; i++) {
                places[i] = (float) ((at(i, stride, size) + 0.5) * map.grid.resolution() * toCoarse);
            }
            return places;
        }
    }

    /// Which column or row of the map's cells a place is in.
    private static int at(int place, int stride, int size) {
        return Math.min(place * stride + stride / 2, size - 1);
    }

    /// What the [#LOOKED_AT] best have at least.
    private static float least(float[] scores) {
        float[] sorted = scores.clone();
        Arrays.sort(sorted);
        return sorted[Math.max(0, sorted.length - LOOKED_AT)];
    }

    /// The one that fits better, with its score.
    Candidate better(Beams beams, Pose2d one, Pose2d other) {
        double scoreOfOne = score(beams, one);
        double scoreOfOther = score(beams, other);
        return scoreOfOne >= scoreOfOther ? new Candidate(scoreOfOne, one) : new Candidate(scoreOfOther, other);
    }

    /// First on a blurred map, then on the sharp one. Gets over hills on which climbing ends.
    Pose2d slide(Beams beams, Pose2d start) {
        return sharp.refine(beams, blurred.refine(beams, start, ABOUT_HERE), ABOUT_HERE);
    }

    /// Hill climbing with ever smaller steps.
    Pose2d climb(Beams beams, Pose2d start) {
        Pose2d pose = start;
        double meters = STEP / 2;
        double radians = Math.PI / HEADINGS;
        for (int round = 0; round < 4; round++) {
            LikelihoodField field = round == 0 ? map.nearWalls : map.walls;
            double score = field.log(beams, pose.x(), pose.y(), pose.theta());
            boolean better = true;
            while (better) {
                better = false;
                for (int distance = 0; distance < 6; distance++) {
                    double sign = distance % 2 == 0 ? 1 : -1;
                    var tried = new Pose2d(
                            pose.x() + (distance / 2 == 0 ? sign * meters : 0),
                            pose.y() + (distance / 2 == 1 ? sign * meters : 0),
                            pose.theta() + (distance / 2 == 2 ? sign * radians : 0));
                    double reached = field.log(beams, tried.x(), tried.y(), tried.theta());
                    if (reached > score && map.grid.isFree(tried.x(), tried.y())) {
                        pose = tried;
                        score = reached;
                        better = true;
                    }
                }
            }
            meters /= 2;
            radians /= 2;
        }
        return pose;
    }

    /// Of many beams some, evenly spread.
    static Beams thin(Beams beams) {
        int every = Math.max(1, Math.ceilDiv(beams.count(), COARSE_BEAMS));
        int count = Math.ceilDiv(beams.count(), every);
        var thin = new Beams(new float[count], new float[count], new float[count], new float[count], beams.cone());
        for (int i = 0; i < count; i++) {
            thin.x()[i] = beams.x()[i * every];
            thin.y()[i] = beams.y()[i * every];
            thin.originX()[i] = beams.originX()[i * every];
            thin.originY()[i] = beams.originY()[i * every];
        }
        return thin;
    }
}
