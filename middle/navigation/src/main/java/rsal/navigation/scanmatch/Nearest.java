package rsal.navigation.scanmatch;

/// The points of a cloud by the cell of a fine grid they lie in, to find the nearest one to a place: rings of
/// cells around it are looked through from the inside, until no nearer point can come.
final class Nearest {
    private static final double CELL = 0.1; // m

    private final double originX;
    private final double originY;
    private final int columns;
    private final int rows;
    private final int[] first; // by cell, into what follows; one more at the end
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
        double toBorder = Math.min(toBorder(x - originX - column * CELL), toBorder(y - originY - row * CELL));
        int nearest = -1;
        double least = within * within;
        for (int ring = 0; ring <= rings; ring++) {
            double free = ring == 0 ? 0 : toBorder + (ring - 1) * CELL; // no point of this ring is nearer
            if (free * free > least) {
                break;
            }
            int step = Math.max(1, 2 * ring);
            for (int r = Math.max(0, row - ring); r <= Math.min(rows - 1, row + ring); r++) {
                boolean whole = r == row - ring || r == row + ring;
                for (int c = column - ring; c <= column + ring; c += whole ? 1 : step) {
                    if (c < 0 || c >= columns) {
                        continue;
                    }
                    int end = first[r * columns + c + 1];
                    for (int i = first[r * columns + c]; i < end; i++) {
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

    private static double toBorder(double inCell) {
        return Math.max(0, Math.min(inCell, CELL - inCell));
    }
}
