package rsal.navigation.jumppoint;

import java.util.Arrays;
import java.util.function.IntPredicate;

/// Where a robot can be, a bit for each cell, by rows and by columns, so that 64 cells are looked at at once.
///
/// A straight scan stops beside the end of an obstacle: in the cell where it first becomes possible to turn to a
/// side on which the cell before was closed. That is all that a shortest way may turn at, as it may not cut corners
/// (block-based scanning: D. Harabor, A. Grastien, Improving Jump Point Search, ICAPS 2014). Immutable.
final class OpenCells {
    final int width;
    final int height;
    private final int rowWords;
    private final int columnWords;
    private final long[] closedInRows; // set where closed; beyond the map all is closed
    private final long[] closedInColumns;

    OpenCells(int width, int height, IntPredicate isOpen) {
        this.width = width;
        this.height = height;
        this.rowWords = words(width);
        this.columnWords = words(height);
        this.closedInRows = new long[rowWords * (height + 2)];
        this.closedInColumns = new long[columnWords * (width + 2)];
        Arrays.fill(closedInRows, -1);
        Arrays.fill(closedInColumns, -1);
        for (int row = 0; row < height; row++) {
            for (int column = 0; column < width; column++) {
                if (isOpen.test(row * width + column)) {
                    open(closedInRows, (row + 1) * rowWords, column + 1);
                    open(closedInColumns, (column + 1) * columnWords, row + 1);
                }
            }
        }
    }

    private static void open(long[] lines, int line, int bit) {
        lines[line + (bit >> 6)] &= ~(1L << bit);
    }

    /// With a closed cell on either side.
    private static int words(int cells) {
        return (cells + 2 + 63) / 64;
    }

    boolean isOpen(int column, int row) {
        int bit = column + 1;
        return (closedInRows[(row + 1) * rowWords + (bit >> 6)] & (1L << bit)) == 0;
    }

    /// Goes along a row until something ends the way or makes it possible to turn.
    ///
    /// @param step 1 or −1
    /// @param goal column at which to stop; −1 when the goal is in another row
    /// @return the column to stop at; −1 when an obstacle comes first
    int alongRow(int column, int row, int step, int goal) {
        return along(closedInRows, rowWords, column, row, step, goal);
    }

    /// The same along a column.
    int alongColumn(int column, int row, int step, int goal) {
        return along(closedInColumns, columnWords, row, column, step, goal);
    }

    /// @param lines bits of which each line has `words` words and the first of each is one before the map
    private static int along(long[] lines, int words, int at, int line, int step, int goal) {
        int here = (line + 1) * words;
        return (step > 0
                        ? forwards(lines, here, words, at + 1, goal + 1)
                        : backwards(lines, here, words, at + 1, goal + 1))
                - 1;
    }

    /// @param at where it comes from, as bit; the first it looks at is the next one
    /// @param goal as bit; 0 when it is elsewhere
    /// @return bit; 0 when an obstacle comes first
    private static int forwards(long[] lines, int here, int words, int at, int goal) {
        int first = at + 1;
        for (int word = first >> 6; word < words; word++) {
            long closed = lines[here + word];
            long stops = closed
                    | opensForwards(lines, here - words, word)
                    | opensForwards(lines, here + words, word)
                    | (goal >> 6 == word && goal != 0 ? 1L << goal : 0);
            if (word == first >> 6) {
                stops &= -1L << first;
            }
            if (stops != 0) {
                int bit = Long.numberOfTrailingZeros(stops);
                return (closed & (1L << bit)) != 0 ? 0 : (word << 6) + bit;
            }
        }
        return 0;
    }

    /// Cells of a line that are open while the one before is closed.
    private static long opensForwards(long[] lines, int line, int word) {
        long closed = lines[line + word];
        long before = (closed << 1) | (word > 0 ? lines[line + word - 1] >>> 63 : 1);
        return ~closed & before;
    }

    private static int backwards(long[] lines, int here, int words, int at, int goal) {
        int first = at - 1;
        for (int word = first >> 6; word >= 0; word--) {
            long closed = lines[here + word];
            long stops = closed
                    | opensBackwards(lines, here - words, word, words)
                    | opensBackwards(lines, here + words, word, words)
                    | (goal >> 6 == word && goal != 0 ? 1L << goal : 0);
            if (word == first >> 6) {
                stops &= -1L >>> (63 - first);
            }
            if (stops != 0) {
                int bit = 63 - Long.numberOfLeadingZeros(stops);
                return (closed & (1L << bit)) != 0 ? 0 : (word << 6) + bit;
            }
        }
        return 0;
    }

    private static long opensBackwards(long[] lines, int line, int word, int words) {
        long closed = lines[line + word];
        long before = (closed >>> 1) | (word + 1 < words ? lines[line + word + 1] << 63 : 1L << 63);
        return ~closed & before;
    }
}
