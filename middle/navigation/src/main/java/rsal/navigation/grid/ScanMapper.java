package rsal.navigation.grid;

import java.util.Arrays;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;

/// Draws a map from scans whose poses are known: S. Thrun, W. Burgard, D. Fox, Probabilistic Robotics (2005),
/// table 9.1, with logarithms of odds.
///
/// Differs from the book in that a beam changes only the cells on its line (tables 9.1 and 9.2 go through all
/// cells and give beams a width), that a beam which hit nothing frees the cells up to [Settings#freeUpTo] only,
/// and that no cell becomes so sure that a few later beams couldn't change it.
///
/// Not safe for several threads at once.
public final class ScanMapper {
    /// 400 m × 400 m at 0.05 m.
    public static final int MOST_CELLS = 1 << 26;

    private final Settings settings;
    private final int width;
    private final int height;
    private final double originX;
    private final double originY;
    private final float[] logOdds;
    private final boolean[] seen;
    private final float passed;
    private final float surest;

    /// @param resolution side of a cell [m]
    /// @param maxRange hits farther than this are not drawn [m]
    /// @param freeUpTo how far a beam that hit nothing frees cells [m]
    /// @param hit logarithm of the odds of a cell in which a beam ends
    /// @param passed logarithm of the odds of a cell through which a beam went, below 0
    /// @param surest logarithm of the odds that no cell exceeds, in either direction
    public record Settings(
            double resolution, double maxRange, double freeUpTo, double hit, double passed, double surest) {
        public Settings {
            if (!(resolution > 0 && maxRange > 0 && freeUpTo >= 0 && hit > 0 && passed < 0 && surest > 0)) {
                throw new IllegalArgumentException(
                        ("Resolution (%s), longest range (%s), odds of hits (%s) and the surest (%s) must be more than"
                                        + " 0, the range freed (%s) not less, and odds of passing (%s) below.")
                                .formatted(resolution, maxRange, hit, surest, freeUpTo, passed));
            }
        }

        /// Hits farther than this are blurred by the heading's error [m].
        public static final double FARTHEST = 30;

        /// A wall stays one when two of three beams see through its cell, as they do that graze it.
        public static Settings of(double resolution) {
            return new Settings(resolution, FARTHEST, 10, 0.9, -0.4, 4);
        }

        /// The same that draws nothing beyond a range [m].
        public Settings within(double range) {
            return upTo(range, Math.min(range, freeUpTo));
        }

        /// The same for other ranges [m].
        public Settings upTo(double farthestHit, double freed) {
            return new Settings(resolution, farthestHit, freed, hit, passed, surest);
        }
    }

    /// Where a scan was taken.
    public record PosedScan(Pose2d mapFromBase, LaserScan scan) {}

    private ScanMapper(Settings settings, double minX, double minY, int width, int height) {
        this.settings = settings;
        this.originX = minX;
        this.originY = minY;
        this.width = width;
        this.height = height;
        this.logOdds = new float[width * height];
        this.seen = new boolean[width * height];
        this.passed = (float) settings.passed();
        this.surest = (float) settings.surest();
    }

    /// A map just large enough for what the scans saw, free or not, with a margin of a few cells.
    ///
    /// @throws IllegalArgumentException when it would have more than [#MOST_CELLS], or a pose is not finite
    public static OccupancyGrid draw(Iterable<PosedScan> scans, Settings settings) {
        double minX = Double.POSITIVE_INFINITY;
        double minY = Double.POSITIVE_INFINITY;
        double maxX = Double.NEGATIVE_INFINITY;
        double maxY = Double.NEGATIVE_INFINITY;
        for (PosedScan posed : scans) {
            Pose2d mapFromLaser = mapFromLaser(posed);
            for (int i = -1; i < posed.scan().count(); i++) {
                double reach = i < 0 ? 0 : seen(posed.scan(), i, settings);
                double direction = mapFromLaser.theta() + posed.scan().angle(Math.max(0, i));
                double x = mapFromLaser.x() + reach * Math.cos(direction);
                double y = mapFromLaser.y() + reach * Math.sin(direction);
                minX = Math.min(minX, x);
                minY = Math.min(minY, y);
                maxX = Math.max(maxX, x);
                maxY = Math.max(maxY, y);
            }
        }
        if (!(minX <= maxX)) {
            throw new IllegalArgumentException("A map can't be drawn from no scans.");
        }
        double cell = settings.resolution();
        double margin = 4 * cell;
        double left = Math.floor((minX - margin) / cell) * cell;
        double low = Math.floor((minY - margin) / cell) * cell;
        double columns = Math.ceil((maxX + margin - left) / cell);
        double rows = Math.ceil((maxY + margin - low) / cell);
        if (!(columns * rows <= MOST_CELLS)) {
            throw new IllegalArgumentException(
                    "The scans span %.0f m × %.0f m: more than %d cells of %s m. Use larger cells."
                            .formatted(maxX - minX, maxY - minY, MOST_CELLS, cell));
        }
        var mapper = new ScanMapper(settings, left, low, (int) columns, (int) rows);
        scans.forEach(mapper::add);
        return mapper.grid();
    }

    private static Pose2d mapFromLaser(PosedScan posed) {
        if (!posed.mapFromBase().isFinite()) {
            throw new IllegalArgumentException("A scan can't be from (%s).".formatted(posed.mapFromBase()));
        }
        return posed.mapFromBase().compose(posed.scan().baseFromLaser());
    }

    /// How far a beam changes cells.
    private static double seen(LaserScan scan, int beam, Settings settings) {
        double hit = hit(scan, beam, settings);
        return hit > 0 ? hit : isFreeing(scan, beam, settings) ? settings.freeUpTo() : 0;
    }

    /// Whether a beam that hits nothing near enough frees cells: not if it is NaN or too close.
    private static boolean isFreeing(LaserScan scan, int beam, Settings settings) {
        return scan.ranges()[beam] > settings.freeUpTo();
    }

    /// Range of a beam that hit something near enough to be drawn, else 0.
    private static double hit(LaserScan scan, int beam, Settings settings) {
        double range = scan.ranges()[beam];
        return scan.isHit(beam) && range <= settings.maxRange() ? range : 0;
    }

    private void add(PosedScan posed) {
        LaserScan scan = posed.scan();
        Pose2d mapFromLaser = mapFromLaser(posed);
        for (int i = 0; i < scan.count(); i++) {
            double direction = mapFromLaser.theta() + scan.angle(i);
            double range = hit(scan, i, settings);
            if (range > 0) {
                free(mapFromLaser, direction, range);
                int hit = cell(
                        mapFromLaser.x() + range * Math.cos(direction), mapFromLaser.y() + range * Math.sin(direction));
                change(hit, (float) settings.hit());
            } else if (isFreeing(scan, i, settings)) {
                free(mapFromLaser, direction, settings.freeUpTo() + settings.resolution());
            }
        }
    }

    /// Frees the cells on a line, but for its last: J. Amanatides, A. Woo, A Fast Voxel Traversal Algorithm for Ray
    /// Tracing (Eurographics 1987).
    private void free(Pose2d from, double direction, double range) {
        double dx = Math.cos(direction);
        double dy = Math.sin(direction);
        double startX = (from.x() - originX) / settings.resolution();
        double startY = (from.y() - originY) / settings.resolution();
        int column = (int) Math.floor(startX);
        int row = (int) Math.floor(startY);
        double length = range / settings.resolution();
        int lastColumn = (int) Math.floor(startX + length * dx);
        int lastRow = (int) Math.floor(startY + length * dy);
        int stepColumn = dx > 0 ? 1 : -1;
        int stepRow = dy > 0 ? 1 : -1;
        double perColumn = Math.abs(1 / dx);
        double perRow = Math.abs(1 / dy);
        double toColumn = (dx > 0 ? column + 1 - startX : startX - column) * perColumn;
        double toRow = (dy > 0 ? row + 1 - startY : startY - row) * perRow;
        int cells = Math.abs(lastColumn - column) + Math.abs(lastRow - row);
        for (int i = 0; i < cells; i++) {
            if (column >= 0 && column < width && row >= 0 && row < height) {
                change(row * width + column, passed);
            }
            if (toColumn < toRow) {
                toColumn += perColumn;
                column += stepColumn;
            } else {
                toRow += perRow;
                row += stepRow;
            }
        }
    }

    private int cell(double x, double y) {
        int column = (int) ((x - originX) / settings.resolution());
        int row = (int) ((y - originY) / settings.resolution());
        return row * width + column; // the map was made large enough
    }

    private void change(int cell, float by) {
        seen[cell] = true;
        logOdds[cell] = Math.max(-surest, Math.min(surest, logOdds[cell] + by)); // Math.clamp takes twice as long
    }

    private OccupancyGrid grid() {
        var cells = new byte[logOdds.length];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        for (int i = 0; i < cells.length; i++) {
            if (seen[i]) {
                cells[i] = logOdds[i] > 0 ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
            }
        }
        return new OccupancyGrid(width, height, settings.resolution(), originX, originY, cells);
    }
}
