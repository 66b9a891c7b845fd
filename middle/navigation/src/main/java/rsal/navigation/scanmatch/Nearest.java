package rsal.navigation.scanmatch;

/// The points of a cloud by the square of a grid they lie in, to find the nearest one to a place.
final class Nearest {
    private final Cloud cloud;
    private final double cell;
    private final double originX;
    private final double originY;
    private final int columns;
    private final int rows;
    private final int[] first; // by cell, into `points`; one more at the end
    private final int[] points;

    /// @param cell side of a square [m]; places are searched for within this
    Nearest(Cloud cloud, double cell) {
        this.cloud = cloud;
        this.cell = cell;
        originX = cloud.least(true) - cell;
        originY = cloud.least(false) - cell;
        double wide = Math.ceil((cloud.most(true) - originX) / cell) + 1;
        double high = Math.ceil((cloud.most(false) - originY) / cell) + 1;
        if (!(wide * high <= Raster.MOST_CELLS)) {
            throw new IllegalArgumentException(
                    "Points to match with span %.0f × %.0f m: too far apart.".formatted(wide * cell, high * cell));
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
        var next = first.clone();
        for (int i = 0; i < cloud.count(); i++) {
            points[next[cell(cloud.x[i], cloud.y[i])]++] = i;
        }
    }

    private int cell(double x, double y) {
        int column = (int) ((x - originX) / cell);
        int row = (int) ((y - originY) / cell);
        return row * columns + column;
    }

    /// The nearest point within a distance that is at most the side of a square; −1 when there is none.
    int find(double x, double y, double within) {
        int column = (int) Math.floor((x - originX) / cell);
        int row = (int) Math.floor((y - originY) / cell);
        int nearest = -1;
        double least = within * within;
        for (int r = Math.max(0, row - 1); r <= Math.min(rows - 1, row + 1); r++) {
            for (int c = Math.max(0, column - 1); c <= Math.min(columns - 1, column + 1); c++) {
                for (int i = first[r * columns + c]; i < first[r * columns + c + 1]; i++) {
                    double dx = cloud.x[points[i]] - x;
                    double dy = cloud.y[points[i]] - y;
                    double square = dx * dx + dy * dy;
                    if (square < least) {
                        least = square;
                        nearest = points[i];
                    }
                }
            }
        }
        return nearest;
    }
}
