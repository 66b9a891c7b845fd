package rsal.sim.world;

import java.util.Arrays;

/// For each cell of a grid of walls and each quadrant of directions, an empty box that begins in the cell and reaches
/// into the quadrant. A ray goes from where it enters a box to where it leaves it at once, so that it needs about two
/// steps in buildings, whose walls are level and upright, instead of six.
///
/// Rays end where a walk from cell to cell (Amanatides and Woo, A Fast Voxel Traversal Algorithm, 1987) ends, to the
/// last bit: a box is left at the border that the walk would come to, and where a ray passes a corner so closely that
/// rounding might decide, its crossings are compared as the walk compares them. Rays that are level or upright, or
/// begin outside the grid, go by [RayMarch].
///
/// Boxes grow by dynamic programming from those of the next cell of the row and of the next row, so they are large but
/// not always the largest. Immutable.
final class EmptyBoxes {
    private static final short SOLID = -1;
    private static final int MOST = 254; // further cells of a box, of each axis: a byte
    private static final int BITS = 8;
    private static final int BYTE = (1 << BITS) - 1;
    private static final int QUADRANTS = 4;
    private static final double STEEP = 1e6; // m per cell, of rays that are level or upright
    private static final double CLOSE = 1e-6; // to a corner [cells]; more than rounding

    private final RasterWalls walls;
    private final int size; // of a quadrant
    private final short[] boxes; // by quadrant and cell: SOLID, or further columns and, in the high byte, rows

    EmptyBoxes(RasterWalls walls) {
        this.walls = walls;
        size = walls.cells();
        boxes = new short[QUADRANTS * size];
        for (int leftward = 0; leftward < 2; leftward++) {
            for (int downward = 0; downward < 2; downward++) {
                measure(leftward, downward);
            }
        }
    }

    private int begin(int leftward, int downward) {
        return size * (leftward + 2 * downward);
    }

    /// Measures the boxes of a quadrant, from its far corner on.
    private void measure(int leftward, int downward) {
        int[] free = new int[walls.width]; // cells of each column, from this row on
        int[] above = new int[walls.width]; // boxes of the row before
        int toRow = ahead(downward);
        int toColumn = ahead(leftward);
        int first = begin(leftward, downward);
        Arrays.fill(above, SOLID);
        int row = downward == 0 ? walls.height - 1 : 0;
        for (int i = 0; i < walls.height; i++, row -= toRow) {
            int run = 0; // free cells of the row, from this column on
            int beside = SOLID;
            int column = leftward == 0 ? walls.width - 1 : 0;
            for (int k = 0; k < walls.width; k++, column -= toColumn) {
                if (walls.roomIn(column, row) == RasterWalls.SOLID) {
                    run = 0;
                    free[column] = 0;
                    beside = SOLID;
                } else {
                    run = Math.min(run + 1, MOST + 1);
                    free[column] = Math.min(free[column] + 1, MOST + 1);
                    beside = largest(run - 1, free[column] - 1, beside, above[column]);
                }
                above[column] = beside;
                boxes[first + walls.at(column, row)] = (short) beside;
            }
        }
    }

    /// The best of a row, a column, and of the two boxes that it may begin before.
    ///
    /// @param run further free columns of the row
    /// @param rise further free rows of the column
    private static int largest(int run, int rise, int beside, int above) {
        int best = better(run, rise << BITS);
        if (beside != SOLID) {
            int columns = Math.min((beside & BYTE) + 1, MOST);
            best = better(best, columns | Math.min(beside >> BITS, rise) << BITS);
        }
        if (above != SOLID) {
            int rows = Math.min((above >> BITS) + 1, MOST);
            best = better(best, Math.min(above & BYTE, run) | rows << BITS);
        }
        return best;
    }

    /// That from which rays get farther on average: with the greater harmonic mean of its sides.
    private static int better(int one, int other) {
        return mean(one) >= mean(other) ? one : other;
    }

    private static double mean(int box) {
        double columns = (box & BYTE) + 1;
        double rows = (box >> BITS) + 1;
        return columns * rows / (columns + rows);
    }

    /// As [RasterWalls#end].
    void end(Rays rays, double reach) {
        int count = rays.count;
        reciprocals(rays.dx, walls.columnsPerMeter, rays.metersPerColumn, count);
        reciprocals(rays.dy, walls.rowsPerMeter, rays.metersPerRow, count);
        int apart = 0;
        for (int i = 0; i < count; i++) {
            double column = (rays.x[i] - walls.left) * walls.columnsPerMeter;
            double row = (rays.y[i] - walls.bottom) * walls.rowsPerMeter;
            double perColumn = rays.metersPerColumn[i];
            double perRow = rays.metersPerRow[i];
            if (Math.max(Math.abs(perColumn), Math.abs(perRow)) > STEEP || !walls.isInside(column, row)) {
                rays.apart[apart++] = i;
                continue;
            }
            double limit = Math.min(reach, rays.range[i]);
            double distance = distance(
                    column,
                    row,
                    rays.dx[i] * walls.columnsPerMeter,
                    rays.dy[i] * walls.rowsPerMeter,
                    perColumn,
                    perRow,
                    limit);
            if (distance <= limit) {
                rays.range[i] = distance;
                rays.met[i] = Rays.WALL;
            }
        }
        if (apart > 0) {
            rays.march(walls, reach, apart);
        }
    }

    /// In a loop of its own, as compilers then divide several at once.
    private static void reciprocals(double[] direction, double cellsPerMeter, double[] metersPerCell, int count) {
        for (int i = 0; i < count; i++) {
            metersPerCell[i] = 1 / (direction[i] * cellsPerMeter + 0.0);
        }
    }

    /// How far a ray gets until it meets a wall [m]; +∞ or more than the limit if it doesn't.
    private double distance(
            double column,
            double row,
            double columnsPerMeter,
            double rowsPerMeter,
            double metersPerColumn,
            double metersPerRow,
            double limit) {
        short[] all = boxes;
        int leftward = negative(metersPerColumn);
        int downward = negative(metersPerRow);
        int first = begin(leftward, downward);
        int c = cell(column, leftward);
        int r = cell(row, downward);
        int box = all[first + walls.at(c, r)];
        double distance = 0;
        while (box != SOLID && distance <= limit) {
            int lastColumn = c + ahead(leftward) * (box & BYTE);
            int lastRow = r + ahead(downward) * (box >> BITS & BYTE);
            double toColumn = crossing(lastColumn, leftward, column, metersPerColumn);
            double toRow = crossing(lastRow, downward, row, metersPerRow);
            if (toColumn < toRow) {
                distance = toColumn;
                c = lastColumn + ahead(leftward);
                double at = row + distance * rowsPerMeter;
                int it = (int) at;
                if (Math.abs(at - it - 0.5) > 0.5 - CLOSE) {
                    it = nearest(r, it, lastRow, downward);
                    while (it != lastRow && crossing(it, downward, row, metersPerRow) <= distance) {
                        it += ahead(downward);
                    }
                }
                r = it;
            } else {
                distance = toRow;
                r = lastRow + ahead(downward);
                double at = column + distance * columnsPerMeter;
                int it = (int) at;
                if (Math.abs(at - it - 0.5) > 0.5 - CLOSE) {
                    it = nearest(c, it, lastColumn, leftward);
                    while (it != lastColumn && crossing(it, leftward, column, metersPerColumn) < distance) {
                        it += ahead(leftward);
                    }
                }
                c = it;
            }
            box = all[first + walls.at(c, r)];
        }
        return box == SOLID && !walls.isFence(c, r) ? distance : Double.POSITIVE_INFINITY;
    }

    /// The cell in which a ray begins; at a border, that into which it goes.
    private static int cell(double from, int backward) {
        int cell = (int) from;
        return cell == from ? cell - backward : cell;
    }

    /// Way of a ray to where it leaves a cell of an axis [m].
    private static double crossing(int cell, int backward, double from, double metersPerCell) {
        return (cell + 1 - backward - from) * metersPerCell;
    }

    /// A cell that is not behind the one in which a ray is, of those from one to another.
    ///
    /// @param rough where it is, or one beside
    private static int nearest(int one, int rough, int other, int backward) {
        return backward == 0 ? Math.clamp(rough - 1, one, other) : Math.clamp(rough + 1, other, one);
    }

    /// 1 upwards, −1 downwards.
    private static int ahead(int backward) {
        return 1 - 2 * backward;
    }

    /// 1 when it is, else 0.
    private static int negative(double number) {
        return (int) (Double.doubleToRawLongBits(number) >>> 63);
    }
}
