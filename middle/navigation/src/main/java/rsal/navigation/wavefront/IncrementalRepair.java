package rsal.navigation.wavefront;

import java.util.Arrays;

/// Takes what a wave has left in the cells of one map over to another that is much the same, and finds out from where
/// it must be passed on again.
///
/// A cell keeps what it holds as long as one of its neighbors that costs less leads to it for no more; those that
/// none leads to any more are forgotten, the cheapest first, as each may be what others of its neighbors hold on to.
/// Cells beside those that were forgotten or have changed are the borders from which the wave spreads again; where
/// ways have become cheaper it overwrites what cells hold. (G. Ramalingam, T. Reps, An Incremental Algorithm for a
/// Generalization of the Shortest-Path Problem, J. Algorithms 21, 1996, for several changes at once as in their
/// section 4; here changed are cells, thus all steps from, to and beside them. They compute what each forgotten cell
/// costs through its neighbors beforehand, here the wave does when it gets there.)
///
/// Of a wave that has not spread over all of the map only what is final is taken over, and all cells that can have a
/// neighbor that is not are borders, too: which of its neighbors a cell left to others was decided on the old map.
///
/// Where too much would be forgotten, as when something comes up beside the source, it gives up: a new wave is sooner
/// where it is wanted.
final class IncrementalRepair {
    private static final int SHARE = 4; // of so many cells one may be forgotten
    private static final int MOST = CostMap.diagonal(2 * CostMap.DEAREST); // that a step costs
    private static final int ROOM = 1024; // at first

    private final CostMap to;
    private final int width;
    private final int[] around; // steps to a cell and its neighbors
    private final int[] field;
    private final Cells checked = new Cells(); // which may have lost what they hold on to
    private final Cells borders = new Cells();
    private final boolean gaveUp;

    /// @param field what the cells of the old map hold; it is written to
    /// @param known cells that hold less are final
    IncrementalRepair(CostChanges changes, int[] field, int known) {
        this.to = changes.to();
        this.width = to.grid().width();
        this.around = new int[] {-width - 1, -width, -width + 1, -1, 0, 1, width - 1, width, width + 1};
        boolean isSameSize = changes.overlay().isSameSize();
        this.field = isSameSize ? field : changes.overlay().moved(field);
        if (!isSameSize) {
            for (int cell : to.shore()) {
                this.field[cell] = Wave.BLOCKED;
            }
        }
        if (known < Wave.OPEN) {
            forgetFrom(known);
        }
        for (int cell : changes.cells()) {
            change(cell);
        }
        for (int cell : changes.cells()) {
            collectAround(cell, checked);
        }
        var forgotten = new Cells();
        gaveUp = !forgetWhatNothingLeadsTo(forgotten);
        if (gaveUp) {
            return;
        }
        for (int i = 0; i < forgotten.count; i++) {
            collectAround(cell(forgotten.entries[i]), borders);
        }
        for (int cell : changes.cells()) {
            collectAround(cell, borders);
        }
        borders.sort();
    }

    /// Whether too much would have been forgotten: there is nothing to go on from then.
    boolean gaveUp() {
        return gaveUp;
    }

    /// What the cells of the new map hold.
    int[] field() {
        return field;
    }

    /// From where to pass it on, the cheapest first: each is a [#cell] and the [#value] that it holds.
    long[] borders() {
        return borders.all();
    }

    static int value(long border) {
        return (int) (border >> 32);
    }

    static int cell(long border) {
        return (int) border;
    }

    private void forgetFrom(int known) {
        for (int cell = 0; cell < field.length; cell++) {
            int value = field[cell];
            if (value >= known - MOST && value < Wave.OPEN) {
                if (value < known || value == Wave.SOURCE) {
                    borders.add(value, cell);
                } else {
                    field[cell] = Wave.OPEN;
                }
            }
        }
    }

    private void change(int cell) {
        if (!to.isOpen(cell)) {
            field[cell] = Wave.BLOCKED;
        } else if (field[cell] < Wave.SOURCE) {
            field[cell] = Wave.OPEN;
        }
        for (int step : around) {
            int next = cell + step;
            if (next >= 0 && next < field.length && !to.isOpen(next)) {
                field[next] = Wave.BLOCKED; // on the shore from now on
            }
        }
    }

    private void collectAround(int cell, Cells into) {
        for (int step : around) {
            int next = cell + step;
            if (next >= 0 && next < field.length && isReached(next)) {
                into.add(field[next], next);
            }
        }
    }

    private boolean isReached(int cell) {
        return field[cell] >= Wave.SOURCE && field[cell] < Wave.OPEN;
    }

    /// @param forgotten to add to
    /// @return whether that was not too much
    private boolean forgetWhatNothingLeadsTo(Cells forgotten) {
        checked.sort();
        long[] first = checked.all();
        var waiting = new BucketQueue();
        int count = 0; // of those that wait
        int next = 0;
        int value = 0;
        while ((count > 0 || next < first.length) && forgotten.count <= field.length / SHARE) {
            value = count > 0 ? value : value(first[next]);
            for (; next < first.length && value(first[next]) == value; next++) {
                waiting.push(value, cell(first[next]), 0);
                count++;
            }
            count -= waiting.count(value);
            for (int i = 0; i < waiting.count(value); i++) { // none is added meanwhile: steps cost something
                int cell = BucketQueue.cell(waiting.entries(value)[i]);
                if (field[cell] == value && !isLedTo(cell)) {
                    field[cell] = Wave.OPEN;
                    forgotten.add(value, cell);
                    count += checkAround(cell, value, waiting);
                }
            }
            waiting.empty(value);
            value++;
        }
        return forgotten.count <= field.length / SHARE;
    }

    /// @return how many
    private int checkAround(int cell, int value, BucketQueue waiting) {
        int count = 0;
        for (int step : around) {
            int next = cell + step;
            if (isReached(next) && field[next] > value && field[next] <= value + MOST) {
                waiting.push(field[next], next, 0);
                count++;
            }
        }
        return count;
    }

    /// Whether a neighbor that costs less leads to a cell for no more than it holds.
    private boolean isLedTo(int cell) {
        int held = field[cell];
        if (held == Wave.SOURCE) {
            return true;
        }
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int next = cell + dy * width + dx;
                boolean diagonal = dx != 0 && dy != 0;
                boolean corner = diagonal && !(to.isOpen(cell + dx) && to.isOpen(cell + dy * width));
                if (!corner
                        && isReached(next)
                        && field[next] < held
                        && field[next] + to.step(cell, next, diagonal) <= held) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Cells with what they hold.
    private static final class Cells {
        private long[] entries = new long[ROOM];
        private int count;

        void add(int value, int cell) {
            if (count == entries.length) {
                entries = Arrays.copyOf(entries, 2 * count);
            }
            entries[count++] = ((long) value << 32) | cell;
        }

        void sort() {
            Arrays.sort(entries, 0, count);
            int kept = 0;
            for (int i = 0; i < count; i++) {
                if (i == 0 || entries[i] != entries[i - 1]) {
                    entries[kept++] = entries[i];
                }
            }
            count = kept;
        }

        long[] all() {
            return Arrays.copyOf(entries, count);
        }
    }
}
