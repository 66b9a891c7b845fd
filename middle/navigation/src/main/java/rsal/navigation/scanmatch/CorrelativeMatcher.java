package rsal.navigation.scanmatch;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// Finds the place within a window at which most points of a scan lie where a reference has points, and
/// misses no better one: E. Olson, Real-Time Correlative Scan Matching (ICRA 2009), searched by branch and
/// bound as in W. Hess et al., Real-Time Loop Closure in 2D LIDAR SLAM (ICRA 2016), algorithm 3.
///
/// Differs from Olson in that the covariance is that of the places tried at the finest level around the best
/// one, and from Hess in that headings are not bounded, too, but all tried. Immutable; may be shared between
/// threads.
public final class CorrelativeMatcher {
    private static final double SHARP = 30; // how fast weights fall with the score; that of a beam is below 1

    private final BlurredRaster raster;

    /// @param resolution of places [m]
    /// @param blur deviation of what was hit from where the reference has it [m]
    /// @param depth levels of the search; with each, windows twice as wide cost about the same
    public record Settings(double resolution, double blur, int depth) {
        public static final Settings DEFAULT = new Settings(0.05, 0.07, 5);

        public Settings {
            if (!(resolution > 0 && blur > 0 && depth >= 0 && depth <= 10)) {
                throw new IllegalArgumentException(
                        "Resolution '%s' and blur '%s' must be more than 0, depth %d 0 to 10."
                                .formatted(resolution, blur, depth));
            }
        }
    }

    /// Where to search: around a guess.
    ///
    /// @param meters so far in x and in y
    /// @param radians so far in heading
    /// @param trust in the guess: what places at the rim lose of their score for being there, and headings
    /// the same; stands for Olson's prior (equation 1)
    public record Window(double meters, double radians, double trust) {
        public Window {
            if (!(meters >= 0 && radians >= 0 && meters < 1e4 && trust >= 0)) {
                throw new IllegalArgumentException("A window of ±%s m and ±%s rad with the trust %s is not allowed."
                        .formatted(meters, radians, trust));
            }
        }

        /// All places are as likely.
        public Window(double meters, double radians) {
            this(meters, radians, 0);
        }

        private double turnLoss(double turn) {
            return radians > 0 ? trust * (turn / radians) * (turn / radians) : 0;
        }

        /// Of the least far of some places.
        private double shiftLoss(double least, double most) {
            double off = least > 0 ? least : Math.min(0, most);
            return meters > 0 ? trust * (off / meters) * (off / meters) : 0;
        }
    }

    /// @param reference in frame `a`
    public CorrelativeMatcher(Cloud reference, Settings settings) {
        raster = new BlurredRaster(reference, settings.resolution(), settings.blur(), settings.depth());
    }

    /// A place and all that counts as the same.
    ///
    /// @param meters so far
    /// @param radians and turned so far
    public record Spot(Pose2d aFromB, double meters, double radians) {}

    /// A turn of the scan whose points are laid into cells.
    ///
    /// @param turn its number, 0 for that of the guess
    /// @param loss for it alone, of the score
    private record Turned(int turn, double theta, double loss, int[] columns, int[] rows) {}

    /// Shifts of it, `2^level` each way from the least.
    ///
    /// @param sum of brightness at most, less what is lost for being far from the guess

    private record Candidate(Turned turned, int columns, int rows, int level, int sum) {}

    /// The best place.
    ///
    /// @param scan in frame `b`
    /// @param guess where `b` is in `a`
    /// @param leastScore what is worse is of no use, 0–1
    /// @return with the mean likeness of a point as its score; empty when nothing is good enough
    public Optional<Match> match(Cloud scan, Pose2d guess, Window window, double leastScore) {
        return best(scan, guess, window, leastScore, null);
    }

    /// The best place but for one and those around it: its rival.
    public Optional<Match> matchElsewhere(Cloud scan, Pose2d guess, Window window, double leastScore, Spot butFor) {
        return best(scan, guess, window, leastScore, butFor);
    }

    private Optional<Match> best(Cloud scan, Pose2d guess, Window window, double leastScore, @Nullable Spot butFor) {
        if (scan.count() == 0 || !guess.isFinite()) {
            return Optional.empty();
        }
        var search = new Search(scan, guess, window, butFor);
        int cells = search.cells;
        int level = Math.min(raster.depth(), 32 - Integer.numberOfLeadingZeros(cells));
        int enough = (int) Math.ceil(leastScore * 255 * scan.count());
        var open = new ArrayList<Candidate>();
        for (int turn = -search.turns; turn <= search.turns; turn++) {
            Turned turned = search.turned(turn);
            for (int row = -cells; row <= cells; row += 1 << level) {
                for (int column = -cells; column <= cells; column += 1 << level) {
                    Candidate candidate = candidate(turned, column, row, level, window);
                    if (candidate.sum >= enough) {
                        open.add(candidate);
                    }
                }
            }
        }
        open.sort(Comparator.comparingInt(Candidate::sum).reversed());
        Candidate best = null;
        for (Candidate candidate : open) {
            int bar = best == null ? enough - 1 : best.sum;
            if (candidate.sum <= bar) {
                break;
            }
            Candidate found = search.descend(candidate, bar);
            best = found == null ? best : found;
        }
        return best == null ? Optional.empty() : Optional.of(search.around(best));
    }

    private Candidate candidate(Turned turned, int columns, int rows, int level, Window window) {
        int count = turned.columns.length;
        double loss = turned.loss
                + window.shiftLoss(columns * raster.resolution, (columns + (1 << level) - 1) * raster.resolution)
                + window.shiftLoss(rows * raster.resolution, (rows + (1 << level) - 1) * raster.resolution);
        int sum = raster.sum(level, turned.columns, turned.rows, count, columns, rows);
        return new Candidate(turned, columns, rows, level, sum - (int) (255 * count * loss));
    }

    /// What is searched for, and where.
    private final class Search {
        private final Cloud scan;
        private final Pose2d guess;
        private final Window window;
        private final @Nullable Spot butFor;
        private final int cells; // to either side
        private final int turns; // the same
        private final double step; // of a turn [rad]; moves no point by more than a cell

        Search(Cloud scan, Pose2d guess, Window window, @Nullable Spot butFor) {
            this.scan = scan;
            this.guess = guess;
            this.window = window;
            this.butFor = butFor;
            this.cells = (int) Math.ceil(window.meters() / raster.resolution);
            double finest = raster.resolution / Math.max(scan.reach(), raster.resolution);
            this.turns = (int) Math.ceil(window.radians() / finest);
            this.step = turns == 0 ? 0 : window.radians() / turns;
        }

        Turned turned(int turn) {
            double theta = guess.theta() + turn * step;
            double cos = Math.cos(theta);
            double sin = Math.sin(theta);
            var columns = new int[scan.count()];
            var rows = new int[scan.count()];
            for (int i = 0; i < columns.length; i++) {
                columns[i] = (int) Math.floor(
                        (guess.x() + cos * scan.x[i] - sin * scan.y[i] - raster.originX) / raster.resolution);
                rows[i] = (int) Math.floor(
                        (guess.y() + sin * scan.x[i] + cos * scan.y[i] - raster.originY) / raster.resolution);
            }
            return new Turned(turn, theta, window.turnLoss(turn * step), columns, rows);
        }

        /// The best of the finest places that a candidate stands for, if it is above the bar.
        @Nullable
        Candidate descend(Candidate candidate, int bar) {
            if (isExcluded(candidate)) {
                return null;
            }
            if (candidate.level == 0) {
                return candidate.sum > bar ? candidate : null;
            }
            int half = 1 << (candidate.level - 1);
            var parts = new ArrayList<Candidate>(4);
            for (int row = 0; row < 2; row++) {
                for (int column = 0; column < 2; column++) {
                    int columns = candidate.columns + column * half;
                    int rows = candidate.rows + row * half;
                    if (columns <= cells && rows <= cells) {
                        parts.add(candidate(candidate.turned, columns, rows, candidate.level - 1, window));
                    }
                }
            }
            parts.sort(Comparator.comparingInt(Candidate::sum).reversed());
            Candidate best = null;
            for (Candidate part : parts) {
                int above = best == null ? bar : best.sum;
                if (part.sum <= above) {
                    break;
                }
                Candidate found = descend(part, above);
                best = found == null ? best : found;
            }
            return best;
        }

        /// Whether all that a candidate stands for is the same as what is left out.
        private boolean isExcluded(Candidate candidate) {
            if (butFor == null
                    || Math.abs(Angles.difference(
                                    candidate.turned.theta, butFor.aFromB().theta()))
                            > butFor.radians()) {
                return false;
            }
            double half = ((1 << candidate.level) - 1) / 2.0;
            double x = guess.x() + (candidate.columns + half) * raster.resolution;
            double y = guess.y() + (candidate.rows + half) * raster.resolution;
            double away =
                    Math.hypot(x - butFor.aFromB().x(), y - butFor.aFromB().y());
            return away + Math.sqrt(2) * half * raster.resolution <= butFor.meters();
        }

        /// With the covariance of the places around the best, weighed by how much worse they are (Olson, section
        /// III-D).
        Match around(Candidate best) {
            double scale = SHARP / (255.0 * scan.count());
            double weights = 0;
            var sums = new double[6]; // xx, xy, x theta, yy, y theta, theta theta
            int middle = best.turned.turn;
            for (int turn = Math.max(-turns, middle - 3); turn <= Math.min(turns, middle + 3); turn++) {
                Turned turned = turned(turn);
                double theta = turned.theta - best.turned.theta;
                for (int row = -4; row <= 4; row++) {
                    for (int column = -4; column <= 4; column++) {
                        Candidate tried = candidate(turned, best.columns + column, best.rows + row, 0, window);
                        double weight = Math.exp((tried.sum - best.sum) * scale);
                        double x = column * raster.resolution;
                        double y = row * raster.resolution;
                        weights += weight;
                        sums[0] += weight * x * x;
                        sums[1] += weight * x * y;
                        sums[2] += weight * x * theta;
                        sums[3] += weight * y * y;
                        sums[4] += weight * y * theta;
                        sums[5] += weight * theta * theta;
                    }
                }
            }
            double cell = raster.resolution * raster.resolution / 12; // of a place anywhere in it
            double ofTurn = cell / Math.max(1, scan.reach() * scan.reach());
            return new Match(
                    new Pose2d(
                            guess.x() + best.columns * raster.resolution,
                            guess.y() + best.rows * raster.resolution,
                            best.turned.theta),
                    new Covariance2d(
                            sums[0] / weights + cell,
                            sums[1] / weights,
                            sums[2] / weights,
                            sums[3] / weights + cell,
                            sums[4] / weights,
                            sums[5] / weights + ofTurn),
                    best.sum / (255.0 * scan.count()));
        }
    }
}
