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
/// What is drawn can be drawn on: scans that are added one after the other give the same map, to the bit, as all
/// of them at once, whatever the map grew to in between. The borders of cells are at multiples of their side.
///
/// Not safe for several threads at once.
public final class ScanMapper {
    /// 400 m × 400 m at 0.05 m.
    public static final int MOST_CELLS = 1 << 26;

    private static final int MARGIN = 4; // cells around what was seen

    private final Settings settings;
    private final float passed;
    private final float surest;
    private Bounds bounds = Bounds.NONE;
    private long left; // columns from the map frame's origin to the first one
    private long low; // the same of rows
    private int width;
    private int height;
    private float[] logOdds = {};
    private boolean[] seen = {};

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
                        ("Resolution '%s', longest range '%s', odds of hits '%s' and the surest '%s' must be more than"
                                        + " 0, the range freed '%s' not less, and odds of passing '%s' below.")
                                .formatted(resolution, maxRange, hit, surest, freeUpTo, passed));
            }
        }

        /// Hits farther than this are blurred by the heading's error [m].
        public static final double FARTHEST = 30;

        /// A wall stays one when two of three beams see through its cell, as they do that graze it.
        public static Settings of(double resolution) {
            return new Settings(resolution, FARTHEST, 10, 0.9, -0.4, 4);
        }

        /// For logs of real lasers: a beam that hit nothing frees no cells. Nothing may have been in range, but as
        /// often its
        /// echo was lost, on glass or something dark, and there is a wall.
        public static Settings ofLogs(double resolution) {
            return of(resolution).upTo(FARTHEST, 0);
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

    /// An empty one.
    public ScanMapper(Settings settings) {
        this.settings = settings;
        this.passed = (float) settings.passed();
        this.surest = (float) settings.surest();
    }

    /// The map of scans, as one that was [added][#add] them draws it.
    ///
    /// @throws IllegalArgumentException when there are no scans, or as `add` does
    public static OccupancyGrid draw(Iterable<PosedScan> scans, Settings settings) {
        var mapper = new ScanMapper(settings);
        mapper.add(scans);
        return mapper.grid();
    }

    /// Draws scans over what is there.
    ///
    /// @throws IllegalArgumentException when the map would have more than [#MOST_CELLS], or a pose is not finite;
    /// nothing is drawn then
    public void add(Iterable<PosedScan> scans) {
        Bounds all = bounds;
        for (PosedScan posed : scans) {
            all = all.with(posed, settings);
        }
        if (all.isEmpty()) {
            return;
        }
        makeRoom(all);
        bounds = all;
        scans.forEach(this::draw);
    }

    /// The map as it is now: just large enough for what the scans saw, free or not, with a margin of a few cells.
    ///
    /// @throws IllegalArgumentException when nothing was drawn
    public OccupancyGrid grid() {
        if (bounds.isEmpty()) {
            throw new IllegalArgumentException("A map can't be drawn from no scans.");
        }
        var cells = new byte[logOdds.length];
        Arrays.fill(cells, OccupancyGrid.UNKNOWN);
        for (int i = 0; i < cells.length; i++) {
            if (seen[i]) {
                cells[i] = logOdds[i] > 0 ? OccupancyGrid.OCCUPIED : OccupancyGrid.FREE;
            }
        }
        double cell = settings.resolution();
        return new OccupancyGrid(width, height, cell, left * cell, low * cell, cells);
    }

    /// What scans saw, in the map frame [m].
    private record Bounds(double minX, double minY, double maxX, double maxY) {
        private static final double INFINITY = Double.POSITIVE_INFINITY;
        static final Bounds NONE = new Bounds(INFINITY, INFINITY, -INFINITY, -INFINITY);

        boolean isEmpty() {
            return !(minX <= maxX);
        }

        Bounds with(PosedScan posed, Settings settings) {
            Pose2d mapFromLaser = mapFromLaser(posed);
            double leastX = Math.min(minX, mapFromLaser.x());
            double leastY = Math.min(minY, mapFromLaser.y());
            double mostX = Math.max(maxX, mapFromLaser.x());
            double mostY = Math.max(maxY, mapFromLaser.y());
            for (int i = 0; i < posed.scan().count(); i++) {
                double reach = seen(posed.scan(), i, settings);
                double direction = mapFromLaser.theta() + posed.scan().angle(i);
                double x = mapFromLaser.x() + reach * Math.cos(direction);
                double y = mapFromLaser.y() + reach * Math.sin(direction);
                leastX = Math.min(leastX, x);
                leastY = Math.min(leastY, y);
                mostX = Math.max(mostX, x);
                mostY = Math.max(mostY, y);
            }
            return new Bounds(leastX, leastY, mostX, mostY);
        }
    }

    /// Makes the grid as large as it must be.
    private void makeRoom(Bounds all) {
        double cell = settings.resolution();
        double margin = MARGIN * cell;
        double leftmost = Math.floor((all.minX - margin) / cell);
        double lowest = Math.floor((all.minY - margin) / cell);
        double columns = Math.ceil((all.maxX + margin) / cell) - leftmost;
        double rows = Math.ceil((all.maxY + margin) / cell) - lowest;
        if (!(columns * rows <= MOST_CELLS)) {
            throw new IllegalArgumentException(
                    "The scans span %.0f m × %.0f m: more than %d cells of %s m. Use larger cells."
                            .formatted(all.maxX - all.minX, all.maxY - all.minY, MOST_CELLS, cell));
        }
        if (columns == width && rows == height) {
            return; // it only grows
        }
        int wide = (int) columns;
        int high = (int) rows;
        var moreOdds = new float[wide * high];
        var moreSeen = new boolean[wide * high];
        int right = (int) (left - leftmost); // so many columns
        int up = (int) (low - lowest);
        for (int row = 0; row < height; row++) {
            System.arraycopy(logOdds, row * width, moreOdds, (row + up) * wide + right, width);
            System.arraycopy(seen, row * width, moreSeen, (row + up) * wide + right, width);
        }
        logOdds = moreOdds;
        seen = moreSeen;
        left = (long) leftmost;
        low = (long) lowest;
        width = wide;
        height = high;
    }

    private static Pose2d mapFromLaser(PosedScan posed) {
        if (!posed.mapFromBase().isFinite()) {
            throw new IllegalArgumentException("A scan can't be from '%s'.".formatted(posed.mapFromBase()));
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

    private void draw(PosedScan posed) {
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

    /// Frees the cells on a line, but for its last: J. Amanatides, A. Woo, A Fast Voxel Traversal Algorithm for
    /// Ray Tracing (Eurographics 1987). Cells are counted from the map frame's origin, so that they are the
    /// same however large the map is.
    private void free(Pose2d from, double direction, double range) {
        double dx = Math.cos(direction);
        double dy = Math.sin(direction);
        double startX = from.x() / settings.resolution();
        double startY = from.y() / settings.resolution();
        double column = Math.floor(startX);
        double row = Math.floor(startY);
        double length = range / settings.resolution();
        double columns = Math.abs(Math.floor(startX + length * dx) - column);
        double rows = Math.abs(Math.floor(startY + length * dy) - row);
        double perColumn = Math.abs(1 / dx);
        double perRow = Math.abs(1 / dy);
        double toColumn = toNext(startX - column, dx, perColumn);
        double toRow = toNext(startY - row, dy, perRow);
        int stepColumn = dx > 0 ? 1 : -1;
        int stepRow = dy > 0 ? width : -width;
        int cell = cell(from.x(), from.y());
        int cells = (int) (columns + rows);
        for (int i = 0; i < cells; i++) {
            change(cell, passed); // within the margin, however it is rounded
            if (toColumn < toRow) {
                toColumn += perColumn;
                cell += stepColumn;
            } else {
                toRow += perRow;
                cell += stepRow;
            }
        }
    }

    /// How far a beam goes, in cells, before it leaves the first column or row.
    ///
    /// @param beyond how far beyond the lower border it starts
    /// @param slope how fast it goes up
    /// @param perCell how far it goes from one border to the next, in cells
    private static double toNext(double beyond, double slope, double perCell) {
        double left = slope > 0 ? 1 - beyond : beyond;
        return slope == 0 ? Double.POSITIVE_INFINITY : left * perCell; // not 0 · ∞
    }

    /// Of a place that was seen.
    private int cell(double x, double y) {
        int column = (int) ((long) Math.floor(x / settings.resolution()) - left);
        int row = (int) ((long) Math.floor(y / settings.resolution()) - low);
        return row * width + column;
    }

    private void change(int cell, float by) {
        seen[cell] = true;
        logOdds[cell] = Math.max(-surest, Math.min(surest, logOdds[cell] + by)); // Math.clamp takes twice as long
    }
}
