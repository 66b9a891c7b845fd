package rsal.navigation.scanmatch;

/// The points of a cloud by the cell of a fine grid they lie in, to find the nearest one to a place: rings of
/// cells around it are looked through from the inside, until no nearer point can come. Rings without points and cells
/// that are too far away are passed over.
final class Nearest {
    private static final double CELL = 0.1; // m
    private static final int MOST_EMPTY = 100;
    private static final double ROUNDING = 1e-9; // m; by which a point may seem to lie beside its cell

    private final double originX;
    private final double originY;
    private final int columns;
    private final int rows;
    private final int[] first; // by cell, into what follows; one more at the end
    private final byte[] empty; // by cell how many rings around it have no points, or [#MOST_EMPTY]
    private final int[] points;
    private final double[] xs;
    private final double[] ys;

    Nearest(Cloud cloud) {
        originX = cloud.least(true) - CELL;
        originY = cloud.least(false) - CELL;
        double wide = Math.ceil((cloud.most(true) - originX) / CELL) + 1;
        double high = Math.ceil((cloud.most(false) - originY) / CELL) + 1;
        if (!(wide * high <= BlurredRaster.MOST_CELLS)) {
            throw new IllegalArgumentException(
                    "Points to match with span %.0f × %.0f m: too far apart.".formatted(wide * CELL, high * CELL));
        }
        columns = (int) wide;
        rows = (int) high;
        first = new int[columns * rows + 1];
        for (int i = 0; i < cloud.count(); i++) {
            first[cell(cloud.x[i], cloud.y[i]) + 1]++;
        }
        for (int i = 0; i < columns * rows; i++) {
            first[i + 1] += first[i];
        }
        empty = emptyRings();
        points = new int[cloud.count()];
        xs = new double[cloud.count()];
        ys = new double[cloud.count()];
        var next = first.clone();
        for (int i = 0; i < cloud.count(); i++) {
            int at = next[cell(cloud.x[i], cloud.y[i])]++;
            points[at] = i;
            xs[at] = cloud.x[i];
            ys[at] = cloud.y[i];
        }
    }

    /// Distances in moves of a king, forward and back (A. Rosenfeld, J. Pfaltz, Sequential Operations in Digital
    /// Picture
    /// Processing, JACM 13, 1966).
    private byte[] emptyRings() {
        var rings = new byte[columns * rows];
        for (int i = 0; i < rings.length; i++) {
            rings[i] = first[i] < first[i + 1] ? 0 : (byte) MOST_EMPTY;
        }
        for (int row = 0; row < rows; row++) {
            for (int column = 0; column < columns; column++) {
                relax(rings, row, column, -1);
            }
        }
        for (int row = rows - 1; row >= 0; row--) {
            for (int column = columns - 1; column >= 0; column--) {
                relax(rings, row, column, 1);
            }
        }
        return rings;
    }

    /// @param side of the neighbors that are done: before is −1, after is 1
    private void relax(byte[] rings, int row, int column, int side) {
        int here = row * columns + column;
        int least = rings[here];
        if (least == 0) {
            return;
        }
        if (column + side >= 0 && column + side < columns) {
            least = Math.min(least, rings[here + side] + 1);
        }
        if (row + side >= 0 && row + side < rows) {
            for (int c = Math.max(0, column - 1); c <= Math.min(columns - 1, column + 1); c++) {
                least = Math.min(least, rings[(row + side) * columns + c] + 1);
            }
        }
        rings[here] = (byte) least;
    }

    private int cell(double x, double y) {
        int column = (int) ((x - originX) / CELL);
        int row = (int) ((y - originY) / CELL);
        return row * columns + column;
    }

    /// The nearest point within a distance; −1 when there is none.
    int find(double x, double y, double within) {
        int column = (int) Math.floor((x - originX) / CELL);
        int row = (int) Math.floor((y - originY) / CELL);
        int rings = (int) Math.ceil(within / CELL);
        if (column < -rings || row < -rings || column >= columns + rings || row >= rows + rings) {
            return -1;
        }
        double inX = x - originX - column * CELL;
        double inY = y - originY - row * CELL;
        double toBorder = Math.min(toBorder(inX), toBorder(inY));
        boolean inside = column >= 0 && row >= 0 && column < columns && row < rows;
        int nearest = -1;
        double least = within * within;
        for (int ring = inside ? empty[row * columns + column] : 0; ring <= rings; ring++) {
            double free = ring == 0 ? 0 : toBorder + (ring - 1) * CELL; // no point of this ring is nearer
            if (free * free > least) {
                break;
            }
            int step = Math.max(1, 2 * ring);
            for (int r = Math.max(0, row - ring); r <= Math.min(rows - 1, row + ring); r++) {
                boolean whole = r == row - ring || r == row + ring;
                double freeY = free(r - row, inY);
                for (int c = column - ring; c <= column + ring; c += whole ? 1 : step) {
                    if (c < 0 || c >= columns) {
                        continue;
                    }
                    int begin = first[r * columns + c];
                    int end = first[r * columns + c + 1];
                    if (begin == end) {
                        continue;
                    }
                    double freeX = free(c - column, inX);
                    if (freeX * freeX + freeY * freeY > least) {
                        continue;
                    }
                    for (int i = begin; i < end; i++) {
                        double dx = xs[i] - x;
                        double dy = ys[i] - y;
                        double square = dx * dx + dy * dy;
                        if (square < least) {
                            least = square;
                            nearest = i;
                        }
                    }
                }
            }
        }
        return nearest < 0 ? -1 : points[nearest];
    }

    /// How far cells are away, at least, that are so many columns or rows farther [m].
    private static double free(int cells, double inCell) {
        double free = cells < 0 ? inCell - (cells + 1) * CELL : cells * CELL - inCell;
        return cells == 0 ? 0 : Math.max(0, free - ROUNDING);
    }

    private static double toBorder(double inCell) {
        return Math.max(0, Math.min(inCell, CELL - inCell));
    }
}
