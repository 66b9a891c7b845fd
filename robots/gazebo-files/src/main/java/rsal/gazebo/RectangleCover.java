package rsal.gazebo;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;

/// Covers the solid cells of a floor plan with few rectangles, which may overlap.
///
/// The fewest are hard to find (Culberson and Reckhow 1994). Here each cell that is not covered yet, row by row, is
/// given the larger of two rectangles without a clear cell: one as wide as can be and then as high, or the other way
/// round. Then those go whose cells others cover.
final class RectangleCover {
    private static final long MOST_COUNTED = 1 << 26; // cells of a plan of which rectangles are taken away again

    /// Some cells.
    ///
    /// @param column of the lower left one
    /// @param row the same
    record Cells(int column, int row, int columns, int rows) {
        long area() {
            return (long) columns * rows;
        }
    }

    private final int width;
    private final int height;
    private final BitSet rows;
    private final BitSet columns; // the same cells, column by column

    private RectangleCover(int width, int height, BitSet solid) {
        this.width = width;
        this.height = height;
        this.rows = solid;
        this.columns = transposed(width, solid);
    }

    private BitSet transposed(int width, BitSet solid) {
        var transposed = new BitSet();
        for (int cell = solid.nextSetBit(0); cell >= 0; cell = solid.nextSetBit(cell + 1)) {
            transposed.set(cell % width * height + cell / width);
        }
        return transposed;
    }

    /// @param solid row by row from the lower left cell
    /// @param most rectangles after which it gives up, below 32,767
    /// @return one more than `most` when there are more
    static List<Cells> of(int width, int height, BitSet solid, int most) {
        return new RectangleCover(width, height, solid).cover(most);
    }

    private List<Cells> cover(int most) {
        var open = (BitSet) rows.clone();
        var cover = new ArrayList<Cells>();
        for (int cell = open.nextSetBit(0); cell >= 0 && cover.size() <= most; cell = open.nextSetBit(cell)) {
            Cells wide = largest(rows, width, height, cell % width, cell / width);
            Cells turned = largest(columns, height, width, cell / width, cell % width);
            var high = new Cells(
                    /* column= */ turned.row(),
                    /* row= */ turned.column(),
                    /* columns= */ turned.rows(),
                    /* rows= */ turned.columns());
            Cells best = wide.area() >= high.area() ? wide : high;
            cover.add(best);
            for (int row = best.row(); row < best.row() + best.rows(); row++) {
                int from = row * width + best.column();
                open.clear(from, from + best.columns());
            }
        }
        return needed(cover);
    }

    /// As wide as can be around a cell, then as high.
    ///
    /// @param lines cells line by line
    /// @param length of a line
    /// @param count of lines
    private static Cells largest(BitSet lines, int length, int count, int at, int line) {
        int begin = line * length;
        int first = Math.max(begin - 1, lines.previousClearBit(begin + at)) + 1 - begin;
        int end = Math.min(begin + length, lines.nextClearBit(begin + at)) - begin;
        int low = line;
        while (low > 0 && isFull(lines, (low - 1) * length, first, end)) {
            low--;
        }
        int high = line + 1;
        while (high < count && isFull(lines, high * length, first, end)) {
            high++;
        }
        return new Cells(first, low, end - first, high - low);
    }

    private static boolean isFull(BitSet lines, int begin, int first, int end) {
        return lines.nextClearBit(begin + first) >= begin + end;
    }

    /// Those without which a cell would not be covered; the small ones go first.
    private List<Cells> needed(List<Cells> cover) {
        if ((long) width * height > MOST_COUNTED) {
            return cover;
        }
        var times = new short[width * height];
        cover.forEach(cells -> count(times, cells, 1));
        var spare = new HashSet<Cells>();
        cover.stream().sorted(Comparator.comparingLong(Cells::area)).forEach(cells -> {
            if (isCoveredTwice(times, cells)) {
                count(times, cells, -1);
                spare.add(cells);
            }
        });
        return cover.stream().filter(cells -> !spare.contains(cells)).toList();
    }

    private void count(short[] times, Cells cells, int by) {
        for (int row = cells.row(); row < cells.row() + cells.rows(); row++) {
            for (int column = cells.column(); column < cells.column() + cells.columns(); column++) {
                times[row * width + column] += (short) by;
            }
        }
    }

    private boolean isCoveredTwice(short[] times, Cells cells) {
        for (int row = cells.row(); row < cells.row() + cells.rows(); row++) {
            for (int column = cells.column(); column < cells.column() + cells.columns(); column++) {
                if (times[row * width + column] < 2) {
                    return false;
                }
            }
        }
        return true;
    }
}
