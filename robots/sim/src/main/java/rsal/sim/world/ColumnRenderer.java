package rsal.sim.world;

import java.util.Arrays;
import java.util.List;
import rsal.scene.Surface;

/// What blob finders tell of in an image of a [CameraRays]: patches of rows one above the other in a column, in
/// each of which one piece or one raster of walls shows. Those of a column come from above, column by column
/// from the left. What blob finders don't tell of hides what is behind it, and is left out.
///
/// Each thread has one of these and uses it again and again.
public final class ColumnRenderer {
    private static final ThreadLocal<ColumnRenderer> OF_THIS_THREAD = ThreadLocal.withInitial(ColumnRenderer::new);
    private static final double TURN = 2 * Math.PI;
    private static final int NONE = -1;
    private static final double[] NO_ROWS = {};

    private int columns;
    private int rowsAbove; // which show nothing
    private double[] slopes = NO_ROWS; // of the rows below those, height over way; falling
    private double apart; // columns [rad]; where they are evenly so
    private double[] clockwise = NO_ROWS; // columns from the first one [rad]; empty where they are evenly apart
    private double[] stretch = NO_ROWS; // by column, of ways along its plane over depth along the optical axis
    private boolean tellsAll; // else only of blobs
    private double z; // of the camera above ground [m]
    private double reach;
    double fromX; // the camera, in the map frame [m]
    double fromY;
    double[] dx = {}; // by column, direction of length 1
    double[] dy = {};

    private int[] last = {}; // by column, what its plane met last; NONE
    private double[] farthest = {}; // by column, how far away what is to be told of ends [m]; less than 0: none there
    private int[] chosen = {}; // columns that look for walls
    private boolean everywhere; // whether what is to be told of may be in rows where nothing was met

    private int met; // how many of these are in use, what planes met:
    private int[] before = {}; // what the same plane met before; NONE
    private int[] first = {}; // row among those with a slope
    private int[] end = {};
    private double[] enters = {}; // way to its near side [m]
    private double[] low = {}; // above the camera [m]
    private double[] high = {};
    private Surface[] surface = {};

    private double[] way = {}; // by row of the column at hand, to what it shows [m]
    private int[] shows = {}; // what was met; NONE

    private int count; // of patches
    private int[] patchColumn = {};
    private int[] patchFirst = {};
    private int[] patchEnd = {};
    private int[] patchMet = {};
    private double[] patchWays = {};
    private int[] patchRows = {}; // where its rows are in:
    private double[] rowWays = {};
    private int rowCount;

    private ColumnRenderer() {}

    /// How columns and rows of an image lie.
    ///
    /// @param apart columns [rad], where they are evenly so
    /// @param clockwise angles of columns from the first one [rad]; empty where they are evenly apart
    /// @param stretch of each column: how many times as far a ray goes along its plane as along the optical
    ///         axis
    /// @param rowsAbove beyond the zenith
    /// @param slopes of the rows under those, height over depth, falling
    record Optics(double apart, double[] clockwise, double[] stretch, int rowsAbove, double[] slopes) {}

    /// That of this thread, of a camera that sees nothing yet.
    static ColumnRenderer ofThisThread(Optics optics, double z, double reach) {
        ColumnRenderer sight = OF_THIS_THREAD.get();
        sight.begin(optics.stretch.length, optics.slopes.length);
        sight.rowsAbove = optics.rowsAbove;
        sight.slopes = optics.slopes;
        sight.columns = optics.stretch.length;
        sight.apart = optics.apart;
        sight.clockwise = optics.clockwise;
        sight.stretch = optics.stretch;
        sight.tellsAll = false;
        sight.z = z;
        sight.reach = reach;
        return sight;
    }

    private void begin(int itsColumns, int rows) {
        if (dx.length < itsColumns) {
            dx = new double[itsColumns];
            dy = new double[itsColumns];
            last = new int[itsColumns];
            farthest = new double[itsColumns];
            chosen = new int[itsColumns];
        }
        if (way.length < rows) {
            way = new double[rows];
            shows = new int[rows];
        }
        Arrays.fill(last, 0, itsColumns, NONE);
        Arrays.fill(farthest, 0, itsColumns, -1);
        met = 0;
        count = 0;
        rowCount = 0;
    }

    /// Tells of all that there is, not only of what blob finders tell of.
    void keepAll() {
        tellsAll = true;
    }

    private boolean tells(Surface its) {
        return tellsAll || its.blob();
    }

    /// How many patches there are.
    public int count() {
        return count;
    }

    /// Where a patch is, counted from the left.
    public int column(int patch) {
        return patchColumn[patch];
    }

    /// Its highest row, counted from the top of the image.
    public int first(int patch) {
        return patchFirst[patch];
    }

    /// One past its lowest row.
    public int end(int patch) {
        return patchEnd[patch];
    }

    public Surface surface(int patch) {
        return surface[patchMet[patch]];
    }

    /// The sum over its rows of how far away, as seen from above, the ray of each meets it [m].
    public double distances(int patch) {
        return patchWays[patch];
    }

    void meetPieces(World world, Body self) {
        SensorView seen = world.sensorView();
        PieceGrid.Found near = Rays.ofThisThread(1).near;
        seen.near(fromX, fromY, reach, near);
        for (int k = 0; k < near.count; k++) {
            int slot = near.slots[k];
            if (seen.owner(slot) != self) {
                meet(seen.piece(slot));
            }
        }
    }

    /// Looks only at columns that may meet the circle around it.
    private void meet(PlacedShape piece) {
        double toX = piece.x() - fromX;
        double toY = piece.y() - fromY;
        double square = toX * toX + toY * toY;
        if (square <= piece.radius() * piece.radius()) {
            meet(piece, toX, toY, 0, columns - 1);
            return;
        }
        double halfWidth = RoughAngles.asinAtLeast(piece.radius() / Math.sqrt(square)) + RoughAngles.ERROR;
        double bearing = RoughAngles.atan2(toX * dy[0] - toY * dx[0], toX * dx[0] + toY * dy[0]); // clockwise
        double start = bearing - halfWidth - TURN * Math.floor((bearing + halfWidth) / TURN); // its end is in [0, 2π)
        double last = clockwise.length == 0 ? (columns - 1) * apart : clockwise[columns - 1];
        for (double turned = start; turned <= last; turned += TURN) {
            meet(piece, toX, toY, firstColumn(turned), lastColumn(turned + 2 * halfWidth));
        }
    }

    /// The first column at least so far clockwise [rad].
    private int firstColumn(double angle) {
        if (clockwise.length == 0) {
            return Math.max(0, (int) Math.ceil(angle / apart));
        }
        int found = Arrays.binarySearch(clockwise, angle);
        return found < 0 ? -found - 1 : found;
    }

    /// The last column at most so far clockwise [rad].
    private int lastColumn(double angle) {
        if (clockwise.length == 0) {
            return Math.min(columns - 1, (int) Math.floor(angle / apart));
        }
        int found = Arrays.binarySearch(clockwise, angle);
        return found < 0 ? -found - 2 : found;
    }

    private void meet(PlacedShape piece, double toX, double toY, int from, int to) {
        double square = piece.radius() * piece.radius();
        for (int column = from; column <= to; column++) {
            double aside = toX * dy[column] - toY * dx[column];
            if (aside * aside <= square) {
                double range = piece.ray(fromX, fromY, dx[column], dy[column]);
                if (range <= reach) {
                    double leaves = Math.min(reach, piece.rayOut(fromX, fromY, dx[column], dy[column]));
                    meet(column, range, leaves, piece.low() - z, piece.high() - z, piece.surface);
                }
            }
        }
    }

    /// Notes a rectangle in the plane of a column that some rows see unless something else hides it.
    private void meet(int column, double from, double to, double lowest, double highest, Surface its) {
        if (to <= 0) {
            return;
        }
        int firstRow = rowsDownTo(stretch[column] * (highest > 0 ? highest / from : highest / to));
        int endRow = rowsDownTo(stretch[column] * (lowest < 0 ? lowest / from : lowest / to));
        if (firstRow >= endRow) {
            return;
        }
        int here = note(from, lowest, highest, its);
        first[here] = firstRow;
        end[here] = endRow;
        before[here] = last[column];
        last[column] = here;
        if (tells(its)) {
            farthest[column] = Math.max(farthest[column], to);
        }
    }

    /// How many rows rise at least as steeply.
    private int rowsDownTo(double slope) {
        int from = 0;
        int to = slopes.length;
        while (from < to) {
            int middle = (from + to) >>> 1;
            if (slopes[middle] >= slope) {
                from = middle + 1;
            } else {
                to = middle;
            }
        }
        return from;
    }

    private int note(double from, double lowest, double highest, Surface its) {
        if (met == before.length) {
            int size = Math.max(64, 2 * met);
            before = Arrays.copyOf(before, size);
            first = Arrays.copyOf(first, size);
            end = Arrays.copyOf(end, size);
            enters = Arrays.copyOf(enters, size);
            low = Arrays.copyOf(low, size);
            high = Arrays.copyOf(high, size);
            surface = Arrays.copyOf(surface, size);
        }
        enters[met] = from;
        low[met] = lowest;
        high[met] = highest;
        surface[met] = its;
        return met++;
    }

    /// Those at the height of the camera, of which each column sees only the front: what passes over its top or below
    /// its bottom is above or below all of them ever after. Walls that are not to be told of are of interest only
    /// where they hide something, so they come last.
    void meetWalls(List<RasterWalls> all) {
        everywhere = false;
        for (RasterWalls walls : all) {
            everywhere |= tells(walls.surface()) && !walls.isAt(z);
        }
        if (everywhere) {
            Arrays.fill(farthest, 0, columns, reach);
        }
        for (RasterWalls walls : all) {
            if (tells(walls.surface()) && walls.isAt(z)) {
                meet(walls);
            }
        }
        for (RasterWalls walls : all) {
            if (!tells(walls.surface()) && walls.isAt(z)) {
                meet(walls);
            }
        }
    }

    private void meet(RasterWalls walls) {
        Rays rays = Rays.ofThisThread(columns);
        rays.count = 0;
        for (int column = 0; column < columns; column++) {
            if (tells(walls.surface()) || farthest[column] >= 0) {
                chosen[rays.count] = column;
                put(rays, rays.count++, column, 0);
                if (!tells(walls.surface())) {
                    rays.range[rays.count - 1] = farthest[column];
                }
            }
        }
        walls.end(rays, reach);
        for (int i = 0; i < rays.count; i++) {
            if (rays.met[i] == Rays.WALL) {
                double range = rays.range[i];
                double depth = Math.nextUp(range); // some, for those inside of it
                meet(chosen[i], range, depth, walls.lowest() - z, walls.highest() - z, walls.surface());
            }
        }
    }

    /// @param from how far it is when it starts [m]
    private void put(Rays rays, int ray, int column, double from) {
        rays.x[ray] = fromX + from * dx[column];
        rays.y[ray] = fromY + from * dy[column];
        rays.dx[ray] = dx[column];
        rays.dy[ray] = dy[column];
        rays.range[ray] = Double.POSITIVE_INFINITY;
        rays.met[ray] = Rays.NOTHING;
    }

    /// Finds the patches.
    void see(List<RasterWalls> walls) {
        for (int column = 0; column < columns; column++) {
            if (farthest[column] >= 0) {
                see(column, walls);
            }
        }
    }

    private void see(int column, List<RasterWalls> walls) {
        int from = everywhere ? 0 : slopes.length;
        int to = everywhere ? slopes.length : 0;
        for (int i = last[column]; i != NONE; i = before[i]) {
            if (tells(surface[i])) {
                from = Math.min(from, first[i]);
                to = Math.max(to, end[i]);
            }
        }
        Arrays.fill(way, from, to, Double.POSITIVE_INFINITY);
        Arrays.fill(shows, from, to, NONE);
        for (int i = last[column]; i != NONE; i = before[i]) {
            show(i, column, Math.max(from, first[i]), Math.min(to, end[i]));
        }
        for (RasterWalls some : walls) {
            if (some.highest() <= z) {
                showFromAbove(some, column, from, to);
            } else if (some.lowest() > z) {
                showFromBelow(some, column, from, to);
            }
        }
        int row = from;
        while (row < to) {
            int start = row;
            double distances = 0;
            while (row < to && shows[row] == shows[start]) {
                distances += way[row++];
            }
            if (shows[start] != NONE && tells(surface[shows[start]])) {
                addPatch(column, start, row, shows[start], distances);
            }
        }
    }

    /// Shows what was met in those rows in which nothing is nearer.
    private void show(int its, int column, int from, int to) {
        double face = low[its] > 0 ? low[its] : high[its]; // which a ray may meet farther away than the near side
        boolean level = low[its] <= 0 && high[its] >= 0;
        for (int row = from; row < to; row++) {
            double itsWay = level ? enters[its] : Math.max(enters[its], stretch[column] * face / slopes[row]);
            show(its, row, itsWay);
        }
    }

    private void show(int its, int row, double itsWay) {
        if (itsWay < way[row]) {
            way[row] = itsWay;
            shows[row] = its;
        }
    }

    /// Walls all of which are lower than the camera: a row sees those cells above which its ray is not yet below the
    /// ground they stand on. The steepest row begins; what it found is found by others as well that begin before
    /// it.
    private void showFromAbove(RasterWalls walls, int column, int from, int to) {
        int its = note(0, 0, 0, walls.surface());
        double found = -1;
        for (int row = to - 1; row >= from && slopes[row] < 0; row--) {
            double begins = stretch[column] * (walls.highest() - z) / slopes[row];
            found = found < begins ? solidFrom(walls, column, begins) : found;
            if (found > reach) {
                return;
            }
            if (found <= stretch[column] * (walls.lowest() - z) / slopes[row]) {
                show(its, row, found);
            }
        }
    }

    /// The same of walls all of which are higher.
    private void showFromBelow(RasterWalls walls, int column, int from, int to) {
        int its = note(0, 0, 0, walls.surface());
        double found = -1;
        for (int row = from; row < to && slopes[row] > 0; row++) {
            double begins = stretch[column] * (walls.lowest() - z) / slopes[row];
            found = found < begins ? solidFrom(walls, column, begins) : found;
            if (found > reach) {
                return;
            }
            if (found <= stretch[column] * (walls.highest() - z) / slopes[row]) {
                show(its, row, found);
            }
        }
    }

    /// How far the first solid cell is that begins there or farther away [m]; +∞ when none is in reach.
    private double solidFrom(RasterWalls walls, int column, double from) {
        if (from > reach) {
            return Double.POSITIVE_INFINITY;
        }
        Rays rays = Rays.ofThisThread(1);
        put(rays, 0, column, from);
        walls.end(rays, reach - from);
        return from + rays.range[0];
    }

    /// Paints what patches show, and how far away that is. What shows nothing stays as it was.
    ///
    /// @param colors by pixel, row by row: 0xRRGGBB
    /// @param depths by pixel, along the optical axis [m]
    void paint(int[] colors, float[] depths) {
        for (int patch = 0; patch < count; patch++) {
            int column = patchColumn[patch];
            int color = surface(patch).color().packed();
            for (int row = patchFirst[patch]; row < patchEnd[patch]; row++) {
                colors[row * columns + column] = color;
                depths[row * columns + column] =
                        (float) (rowWays[patchRows[patch] + row - patchFirst[patch]] / stretch[column]);
            }
        }
    }

    private void addPatch(int column, int firstRow, int endRow, int its, double distances) {
        if (count == patchColumn.length) {
            int size = Math.max(64, 2 * count);
            patchColumn = Arrays.copyOf(patchColumn, size);
            patchFirst = Arrays.copyOf(patchFirst, size);
            patchEnd = Arrays.copyOf(patchEnd, size);
            patchMet = Arrays.copyOf(patchMet, size);
            patchWays = Arrays.copyOf(patchWays, size);
        }
        patchColumn[count] = column;
        patchFirst[count] = rowsAbove + firstRow;
        patchEnd[count] = rowsAbove + endRow;
        patchMet[count] = its;
        patchWays[count] = distances;
        if (tellsAll) {
            noteRows(firstRow, endRow);
        }
        count++;
    }

    /// Keeps how far each row of the patch looks, which are as many as pixels.
    private void noteRows(int firstRow, int endRow) {
        if (patchRows.length < patchColumn.length) {
            patchRows = Arrays.copyOf(patchRows, patchColumn.length);
        }
        int rows = endRow - firstRow;
        if (rowCount + rows > rowWays.length) {
            rowWays = Arrays.copyOf(rowWays, Math.max(1024, 2 * (rowCount + rows)));
        }
        patchRows[count] = rowCount;
        System.arraycopy(way, firstRow, rowWays, rowCount, rows);
        rowCount += rows;
    }
}
