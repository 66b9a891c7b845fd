package rsal.navigation.wavefront;

import java.util.Arrays;
import org.jspecify.annotations.Nullable;

/// A wave that spreads from one cell of a [CostMap] over the eight neighbors of each and leaves in each cell what
/// the way between there and its source costs. Ways do not squeeze through between two corners.
///
/// The wave is ordered by R. Dial's buckets (Algorithm 360, CACM 12, 1969), since costs are small whole numbers.
///
/// Over plains, cells around which nothing is dear, it runs straight on without asking the buckets, and passes on
/// only what those neighbors can use whom it does not reach as cheaply otherwise: from a straight step the next
/// straight one, from a diagonal step the next and the two straight ones that it is made of (the pruning rules of
/// D. Harabor, A. Grastien, Online Graph Pruning for Pathfinding on Grid Maps, AAAI 2011; N. Sturtevant, S. Rabin,
/// Canonical Orderings on Grids, IJCAI 2016; unlike theirs, runs write into the cells that they cross and end where
/// these were reached as cheaply before).
///
/// A [Guide] hurries it towards a cell (P. Hart, N. Nilsson, B. Raphael, 1968). What it leaves in the cells of
/// cheapest ways to that cell depends neither on the guide nor on the order in which it gets there, for it goes on
/// until all of them are found.
///
/// Starts anew without allocating. Not safe for several threads at once.
final class Wave {
    /// The value of a cell that the wave did not reach.
    static final int UNREACHED = Integer.MAX_VALUE;

    private static final int BLOCKED = -1; // in the field, so that one look tells whether a cell is open
    private static final int BUCKETS = 2048; // a power of 2, more than twice what a run and two steps cost
    private static final int ROOM = 32; // of a bucket at first
    private static final int RUN = 800; // what a straight run may cost
    private static final int DIAGONAL_RUN = 100; // the same of a diagonal one: it may well be overtaken
    private static final int SIDE = CostMap.SIDE;
    private static final int DIAGONAL = CostMap.diagonal(CostMap.SIDE);

    private final CostMap map;
    private final byte[] costs;
    private final boolean[] plains;
    private final int width;
    private final int[] field;
    private final int[][] buckets = new int[BUCKETS][ROOM];
    private final int[] counts = new int[BUCKETS];
    private @Nullable Guide guide;
    private boolean blocked; // some cells, unlike in the map
    private int front; // the next bucket
    private int lowest; // of the cells that are not as in the map
    private int highest;

    /// The least that a way from a cell on to where the wave hurries can cost; between neighbors it differs by no
    /// more than the step (it is consistent), and it is 0 there.
    @FunctionalInterface
    interface Guide {
        int least(int cell);
    }

    Wave(CostMap map) {
        this.map = map;
        this.costs = map.costs();
        this.plains = map.plains();
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
        blocked = false;
        lowest = field.length;
        highest = -1;
    }

    /// Lets nothing through a cell until it is cleared. To be called before it starts.
    void block(int cell) {
        field[cell] = BLOCKED;
        blocked = true;
        touched(cell);
    }

    /// Starts from a cell that is open and spreads alike in every direction; from several when told so before it
    /// spreads.
    void start(int source) {
        start(source, null);
    }

    /// Starts from a cell that is open.
    ///
    /// @param towards where to; if null, every direction is as good
    void start(int source, @Nullable Guide towards) {
        guide = towards;
        field[source] = 0;
        front = least(source);
        push(source, front);
        touched(source);
    }

    /// Spreads on until it is known what the way to a cell costs.
    ///
    /// @param target −1 lets it reach everything
    /// @return whether it reaches the target
    boolean spread(int target) {
        int empty = 0; // buckets in a row
        while (empty < BUCKETS && (target < 0 || field[target] == UNREACHED || field[target] >= front)) {
            empty = counts[bucket(front)] == 0 ? empty + 1 : 0;
            expand();
            front++;
        }
        return target >= 0 && field[target] != UNREACHED;
    }

    /// What the way between a cell and the source costs, negative where nothing can be. Without a guide it is final
    /// if it costs less than what is [#known].
    int at(int cell) {
        return field[cell];
    }

    boolean isOpen(int cell) {
        return field[cell] >= 0;
    }

    /// All ways that cost less are known.
    int known() {
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
    private void expand() {
        int bucket = bucket(front);
        int done = 0;
        while (done < counts[bucket]) {
            int count = counts[bucket];
            expand(buckets[bucket], done, count);
            done = count;
        }
        counts[bucket] = 0;
    }

    private void expand(int[] cells, int from, int to) {
        int[] field = this.field; // the compiler would look them up again after each step
        byte[] costs = this.costs;
        int up = width;
        int now = front;
        int run = blocked ? 0 : RUN;
        for (int i = from; i < to; i++) {
            int cell = cells[i];
            int reached = field[cell];
            int most = reached + run;
            if (reached + least(cell) != now) {
                continue; // was reached for less since
            }
            int cost = costs[cell];
            int left = field[cell - 1];
            int right = field[cell + 1];
            int below = field[cell - up];
            int above = field[cell + up];
            if (left > reached) {
                straight(field, cell - 1, -1, reached + cost + costs[cell - 1], most);
            }
            if (right > reached) {
                straight(field, cell + 1, 1, reached + cost + costs[cell + 1], most);
            }
            if (below > reached) {
                straight(field, cell - up, -up, reached + cost + costs[cell - up], most);
            }
            if (above > reached) {
                straight(field, cell + up, up, reached + cost + costs[cell + up], most);
            }
            if ((left | below) >= 0) {
                across(field, cell, -1, -up, most);
            }
            if ((right | below) >= 0) {
                across(field, cell, 1, -up, most);
            }
            if ((left | above) >= 0) {
                across(field, cell, -1, up, most);
            }
            if ((right | above) >= 0) {
                across(field, cell, 1, up, most);
            }
            touched(cell - up - 1);
            touched(cell + up + 1);
        }
    }

    private void across(int[] field, int from, int dx, int dy, int most) {
        int cell = from + dx + dy;
        int reached = field[from];
        if (field[cell] > reached) {
            diagonal(field, cell, dx, dy, reached + CostMap.diagonal(costs[from] + costs[cell]), most);
        }
    }

    /// Reaches a cell along a side and, over plains, those behind it that cost no more than `most`.
    private void straight(int[] field, int first, int step, int cost, int most) {
        boolean[] plains = this.plains;
        int cell = first;
        int now = cost;
        while (now < field[cell]) {
            field[cell] = now;
            if (!plains[cell] || now > most) {
                push(cell, now + least(cell));
                break;
            }
            cell += step;
            now += SIDE;
        }
        touched(cell);
    }

    /// Reaches a cell across a corner and, over plains, those behind it and beside these.
    private void diagonal(int[] field, int first, int dx, int dy, int cost, int most) {
        int far = most - RUN + DIAGONAL_RUN;
        int cell = first;
        int now = cost;
        while (now < field[cell]) {
            field[cell] = now;
            if (!plains[cell] || now > far) {
                push(cell, now + least(cell));
                break;
            }
            straight(field, cell + dx, dx, now + SIDE, most);
            straight(field, cell + dy, dy, now + SIDE, most);
            cell += dx + dy;
            now += DIAGONAL;
        }
        touched(cell);
    }

    private void touched(int cell) {
        lowest = Math.min(lowest, cell);
        highest = Math.max(highest, cell);
    }

    private int least(int cell) {
        return guide == null ? 0 : guide.least(cell);
    }

    private static int bucket(int number) {
        return number & (BUCKETS - 1);
    }

    private void push(int cell, int value) {
        int bucket = bucket(value);
        int count = counts[bucket];
        if (count == buckets[bucket].length) {
            buckets[bucket] = Arrays.copyOf(buckets[bucket], 2 * count);
        }
        buckets[bucket][count] = cell;
        counts[bucket] = count + 1;
    }
}
