package rsal.navigation.wavefront;

import java.util.Arrays;

/// A wave that spreads from one cell of a [CostMap] over the eight neighbors of each and leaves in each cell what
/// the way between there and its source costs. Ways do not squeeze through between two corners.
///
/// The wave is ordered by R. Dial's buckets (Algorithm 360, CACM 12, 1969), since costs are small whole numbers. A
/// [Guide] hurries it towards a cell (P. Hart, N. Nilsson, B. Raphael, 1968). What it leaves in the cells of
/// cheapest ways to that cell depends neither on the guide nor on the order in which it gets there, for it goes on
/// until all of them are found.
///
/// Starts anew without allocating. Not safe for several threads at once.
final class Wave {
    /// The value of a cell that the wave did not reach.
    static final int UNREACHED = Integer.MAX_VALUE;

    private static final int BLOCKED = -1; // in the field, so that one look tells whether a cell is open
    private static final int BUCKETS = 512; // a power of 2, more than twice what a step costs
    private static final int ROOM = 256; // of a bucket at first

    private final CostMap map;
    private final byte[] costs;
    private final int width;
    private final int[] field;
    private final int[][] buckets = new int[BUCKETS][ROOM];
    private final int[] counts = new int[BUCKETS];
    private int waiting; // cells in buckets
    private int front; // all that costs less is final
    private int lowest; // of the cells that are not as in the map
    private int highest;

    /// The least that a way from a cell on to where the wave hurries can cost; between neighbors it differs by no
    /// more than the step (it is consistent), and it is 0 there.
    @FunctionalInterface
    interface Guide {
        int least(int cell);

        /// Every direction is as good.
        Guide NONE = _ -> 0;
    }

    Wave(CostMap map) {
        this.map = map;
        this.costs = map.costs();
        this.width = map.grid().width();
        this.field = new int[costs.length];
        this.highest = field.length - 1;
        clear();
    }

    /// Forgets where it was and what was blocked.
    void clear() {
        for (int cell = lowest; cell <= highest; cell++) {
            field[cell] = costs[cell] == CostMap.BLOCKED ? BLOCKED : UNREACHED;
        }
        Arrays.fill(counts, 0);
        lowest = field.length;
        highest = -1;
        waiting = 0;
    }

    /// Lets nothing through a cell until it is cleared. To be called before it starts.
    void block(int cell) {
        field[cell] = BLOCKED;
        note(cell);
    }

    /// Starts from a cell that is open.
    void start(int source, Guide guide) {
        field[source] = 0;
        front = guide.least(source);
        push(source, front);
    }

    /// Spreads on until it is known what the way to a cell costs.
    ///
    /// @param target −1 lets it reach everything
    /// @param guide the one that it started with
    /// @return whether it reaches the target
    boolean spread(int target, Guide guide) {
        while (waiting > 0 && (target < 0 || field[target] == UNREACHED || field[target] >= front)) {
            expand(guide);
            front++;
        }
        return target >= 0 && field[target] != UNREACHED;
    }

    /// What the way between a cell and the source costs, negative where nothing can be. Without a guide it is final
    /// if it costs less than [#front].
    int at(int cell) {
        return field[cell];
    }

    boolean isOpen(int cell) {
        return field[cell] >= 0;
    }

    int front() {
        return front;
    }

    /// The neighbor from which the wave came; of several the first by row, then column; −1 at the source.
    int towardsSource(int cell) {
        int best = -1;
        int least = UNREACHED;
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int next = cell + dy * width + dx;
                boolean diagonal = dx != 0 && dy != 0;
                boolean corner = diagonal && (field[cell + dx] < 0 || field[cell + dy * width] < 0);
                if (corner || field[next] < 0 || field[next] >= field[cell]) {
                    continue;
                }
                int through = field[next] + map.step(cell, next, diagonal);
                if (through < least) {
                    least = through;
                    best = next;
                }
            }
        }
        return best;
    }

    /// Lets all cells of the next bucket pass the wave on. A guide may say that a step costs nothing: then cells are
    /// added to the bucket meanwhile.
    private void expand(Guide guide) {
        int bucket = front & BUCKETS - 1;
        for (int i = 0; i < counts[bucket]; i++) {
            int cell = buckets[bucket][i];
            int reached = field[cell];
            if (reached + guide.least(cell) != front) {
                continue; // was reached for less since
            }
            int cost = costs[cell];
            boolean left = relax(cell - 1, reached + cost + costs[cell - 1], guide);
            boolean right = relax(cell + 1, reached + cost + costs[cell + 1], guide);
            boolean below = relax(cell - width, reached + cost + costs[cell - width], guide);
            boolean above = relax(cell + width, reached + cost + costs[cell + width], guide);
            if (left && below) {
                relax(cell - width - 1, reached + CostMap.diagonal(cost + costs[cell - width - 1]), guide);
            }
            if (right && below) {
                relax(cell - width + 1, reached + CostMap.diagonal(cost + costs[cell - width + 1]), guide);
            }
            if (left && above) {
                relax(cell + width - 1, reached + CostMap.diagonal(cost + costs[cell + width - 1]), guide);
            }
            if (right && above) {
                relax(cell + width + 1, reached + CostMap.diagonal(cost + costs[cell + width + 1]), guide);
            }
        }
        waiting -= counts[bucket];
        counts[bucket] = 0;
    }

    /// @return whether the cell is open
    private boolean relax(int cell, int now, Guide guide) {
        int old = field[cell];
        if (now < old) {
            field[cell] = now;
            push(cell, now + guide.least(cell));
        }
        return old >= 0;
    }

    private void push(int cell, int value) {
        int bucket = value & BUCKETS - 1;
        int count = counts[bucket];
        if (count == buckets[bucket].length) {
            buckets[bucket] = Arrays.copyOf(buckets[bucket], 2 * count);
        }
        buckets[bucket][count] = cell;
        counts[bucket] = count + 1;
        waiting++;
        note(cell);
    }

    private void note(int cell) {
        lowest = Math.min(lowest, cell);
        highest = Math.max(highest, cell);
    }
}
