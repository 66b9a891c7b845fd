package rsal.data;

/// A map of square cells, row by row from the lower left one (`nav_msgs/OccupancyGrid`).
///
/// @param width number of columns
/// @param height number of rows
/// @param resolution side of a cell [m]
/// @param originX x of the lower left corner of the lower left cell, in the map frame [m]
/// @param originY y of that corner [m]
/// @param cells [#FREE], [#OCCUPIED] or [#UNKNOWN], `width · height` of them; in a grid of costs also values
/// between; handed over, not shared
public record OccupancyGrid(int width, int height, double resolution, double originX, double originY, byte[] cells) {

    public static final byte FREE = 0;
    public static final byte OCCUPIED = 100;
    public static final byte UNKNOWN = -1;

    public OccupancyGrid {
        if (width <= 0 || height <= 0 || (long) width * height != cells.length) {
            throw new IllegalArgumentException(
                    "A grid of %d × %d cells needs as many values, not %d.".formatted(width, height, cells.length));
        }
        if (!(resolution > 0 && Double.isFinite(resolution))
                || !Double.isFinite(originX)
                || !Double.isFinite(originY)) {
            throw new IllegalArgumentException(
                    "A grid's resolution '%s' must be positive and its origin (%s, %s) finite."
                            .formatted(resolution, originX, originY));
        }
    }

    /// Column of a place in the map frame; outside `0 … width-1` when the place is outside.
    public int column(double x) {
        return index(x - originX);
    }

    /// Row of a place in the map frame; outside `0 … height-1` when the place is outside.
    public int row(double y) {
        return index(y - originY);
    }

    private int index(double fromEdge) {
        double index = Math.floor(fromEdge / resolution);
        return Double.isNaN(index) ? -1 : (int) index; // a cast alone would take NaN for the first cell
    }

    /// x of the middle of a column [m].
    public double x(int column) {
        return originX + (column + 0.5) * resolution;
    }

    /// y of the middle of a row [m].
    public double y(int row) {
        return originY + (row + 0.5) * resolution;
    }

    /// Number of the cell at a place on the map, as in [#cells].
    public int cell(Point2d place) {
        return row(place.y()) * width + column(place.x());
    }

    /// The middle of a cell in the map frame [m].
    ///
    /// @param cell its number
    public Point2d middle(int cell) {
        return new Point2d(x(cell % width), y(cell / width));
    }

    public boolean contains(int column, int row) {
        return column >= 0 && column < width && row >= 0 && row < height;
    }

    /// The cell's value; what is outside the map is unknown.
    public byte at(int column, int row) {
        return contains(column, row) ? cells[row * width + column] : UNKNOWN;
    }

    /// What a pixel shows that several cells share: occupied when one of them is, else free when one is, else unknown.
    ///
    /// @param left first column
    /// @param bottom first row
    /// @param right column behind the last one
    /// @param top row above the last one
    public byte darkest(int left, int bottom, int right, int top) {
        byte darkest = UNKNOWN;
        for (int row = bottom; row < top; row++) {
            for (int column = left; column < right; column++) {
                byte cell = at(column, row);
                if (cell == OCCUPIED) {
                    return OCCUPIED;
                }
                darkest = cell == FREE ? FREE : darkest;
            }
        }
        return darkest;
    }

    /// Whether a place is known to be free.
    public boolean isFree(double x, double y) {
        return at(column(x), row(y)) == FREE;
    }
}
