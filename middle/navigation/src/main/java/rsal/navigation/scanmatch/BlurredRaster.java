package rsal.navigation.scanmatch;

import java.util.Arrays;

/// A cloud drawn into cells, blurred as the laser errs, and the same ever coarser, each cell of which is as
/// bright as the brightest that it may stand for: W. Hess et al., Real-Time Loop Closure in 2D LIDAR SLAM
/// (ICRA 2016), section V-B.
///
/// A cell of level `h` stands for the `2^h × 2^h` finest ones above and to the right of its own place.
final class BlurredRaster {
    /// 400 m × 100 m at 0.05 m.
    static final int MOST_CELLS = 1 << 24;

    final double resolution;
    final double originX;
    final double originY;
    final int width;
    final int height;
    private final byte[][] levels;

    /// @param blur deviation of what was hit from where it is drawn [m]
    /// @param depth levels besides the finest
    BlurredRaster(Cloud cloud, double resolution, double blur, int depth) {
        this.resolution = resolution;
        int reach = (int) Math.ceil(3 * blur / resolution);
        double margin = (reach + 1) * resolution;
        originX = cloud.least(true) - margin;
        originY = cloud.least(false) - margin;
        double columns = Math.ceil((cloud.most(true) + margin - originX) / resolution) + 1;
        double rows = Math.ceil((cloud.most(false) + margin - originY) / resolution) + 1;
        if (!(columns * rows <= MOST_CELLS)) {
            throw new IllegalArgumentException(
                    "Points to match with span %.0f × %.0f cells, more than %d. Use larger cells or fewer points."
                            .formatted(columns, rows, MOST_CELLS));
        }
        width = (int) columns;
        height = (int) rows;
        levels = new byte[depth + 1][];
        levels[0] = draw(cloud, reach, blur);
        for (int level = 1; level <= depth; level++) {
            levels[level] = coarser(levels[level - 1], 1 << (level - 1));
        }
    }

    private byte[] draw(Cloud cloud, int reach, double blur) {
        var cells = new byte[width * height];
        double[] brightness = new double[1 << 12];
        double step = 3.5 * blur * 3.5 * blur / brightness.length;
        Arrays.setAll(brightness, i -> 255 * Math.exp(-i * step / (2 * blur * blur)));
        double[] beyond = beyond(brightness, step);
        var squares = new double[2 * reach + 1]; // by column
        for (int i = 0; i < cloud.count(); i++) {
            int column = (int) ((cloud.x[i] - originX) / resolution);
            int row = (int) ((cloud.y[i] - originY) / resolution);
            for (int c = 0; c < squares.length; c++) {
                double dx = originX + (column - reach + c + 0.5) * resolution - cloud.x[i];
                squares[c] = dx * dx;
            }
            for (int r = row - reach; r <= row + reach; r++) {
                double dy = originY + (r + 0.5) * resolution - cloud.y[i];
                double squareY = dy * dy;
                int first = r * width + column - reach;
                for (int c = 0; c < squares.length; c++) {
                    double square = squares[c] + squareY;
                    int before = cells[first + c] & 0xff;
                    if (square < beyond[before]) {
                        int index = (int) (square / step);
                        if (index < brightness.length) {
                            cells[first + c] = (byte) Math.max(before, (int) brightness[index]);
                        }
                    }
                }
            }
        }
        return cells;
    }

    /// By brightness the square of a distance from which on nothing makes a cell of it brighter: most cells, since
    /// points of a wall lie side by side. A division less for each.
    private static double[] beyond(double[] brightness, double step) {
        var beyond = new double[256];
        int index = brightness.length;
        for (int value = 0; value < beyond.length; value++) {
            while (index > 0 && (int) brightness[index - 1] <= value) {
                index--;
            }
            beyond[value] = index * step * (1 + 1e-9); // however it is rounded
        }
        return beyond;
    }

    private byte[] coarser(byte[] fine, int shift) {
        var cells = new byte[fine.length];
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                int here = row * width + column;
                int most = fine[here] & 0xff;
                boolean right = column + shift < width;
                if (right) {
                    most = Math.max(most, fine[here + shift] & 0xff);
                }
                if (row + shift < height) {
                    most = Math.max(most, fine[here + shift * width] & 0xff);
                    if (right) {
                        most = Math.max(most, fine[here + shift * width + shift] & 0xff);
                    }
                }
                cells[here] = (byte) most;
            }
        }
        return cells;
    }

    int depth() {
        return levels.length - 1;
    }

    /// Sum of the brightness of the cells of points, 255 for each that lies just where something was hit.
    ///
    /// @param columns of the points, to which `shiftColumns` is added
    int sum(int level, int[] columns, int[] rows, int count, int shiftColumns, int shiftRows) {
        byte[] cells = levels[level];
        int before = (1 << level) - 1; // cells left of the raster that stand for some in it
        int sum = 0;
        for (int i = 0; i < count; i++) {
            int column = columns[i] + shiftColumns;
            int row = rows[i] + shiftRows;
            if (column >= 0 && column < width && row >= 0 && row < height) {
                sum += cells[row * width + column] & 0xff;
            } else if (column >= -before && column < width && row >= -before && row < height) {
                sum += cells[Math.max(0, row) * width + Math.max(0, column)] & 0xff;
            }
        }
        return sum;
    }
}
