package rsal.navigation.wavefront;

import java.util.Arrays;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/// A wave that spreads from one cell of a [CostMap] over the eight neighbors of each and leaves in each cell
/// what the way between there and its source costs. Ways do not squeeze through between two corners.
///
/// The wave is ordered by R. Dial's buckets (Algorithm 360, CACM 12, 1969), since costs are small whole
/// numbers.
///
/// A cell passes on only what its neighbors can use whom the cell before it does not reach for less by itself:
/// it leaves out that one and those on either side of it that both of them border. Over plains, cells around
/// which nothing is dear, the wave runs straight on without asking the buckets and passes on still less: from a
/// straight step the next straight one, from a diagonal step the next and the two straight ones that it is made
/// of. (The pruning rules of D. Harabor, A. Grastien, Online Graph Pruning for Pathfinding on Grid Maps, AAAI
/// 2011; N. Sturtevant, S. Rabin, Canonical Orderings on Grids, IJCAI 2016. Unlike theirs, those outside of
/// plains hold whatever cells cost, and runs write into the cells that they cross and end where these were
/// reached as cheaply before.)
///
/// A step across a corner is left out, too, when a cell beside it that was reached already leads to the same
/// one for no more: else that would be reached, and pass the wave on, twice wherever the wave runs aslant.
///
/// That neighbors are named by the direction in which the wave goes, not by that on the map, also lets the
/// processor foresee which of them it reaches; it takes most of its time for what was not foreseen.
///
/// A [Guide] hurries it towards a cell (P. Hart, N. Nilsson, B. Raphael, 1968). What it leaves in the cells of
/// cheapest ways to that cell depends neither on the guide nor on the order in which it gets there, for it goes
/// on until all of them are found.
///
/// Starts again without allocating. When the map has changed a little it is mended rather than started again
/// ([#over], [IncrementalRepair]). Not safe for several threads at once.
final class Wave {
    /// The value of a cell that the wave did not reach.
    static final int UNREACHED = Integer.MAX_VALUE;

    private static final int BUCKETS = BucketQueue.COUNT; // more than twice what a run and two steps cost
    private static final int RUN = 800; // what a straight run may cost
    private static final int DIAGONAL_RUN = 100; // the same of a diagonal one: it may well be overtaken
    private static final int SIDE = CostMap.SIDE;
    private static final int DIAGONAL = CostMap.diagonal(CostMap.SIDE);

    // In the field, in which a way's cost is added to that of the source: so a new array needs no filling.
    static final int OPEN = 0; // and not reached
    static final int SOURCE = -(1 << 30); // all that is less is blocked
    static final int BLOCKED = Integer.MIN_VALUE;
    private static final int FARTHEST = OPEN - BUCKETS; // that the wave passes on, so that all it reaches is below OPEN

    private final CostMap map;
    private final byte[] ground;
    private final int width;
    private final int[] field;
    private final int[] steps; // to the neighbors along the sides, counter-clockwise from +x, the first again at last
    private final BucketQueue along =
            new BucketQueue(); // cells reached along a side, each with the quarter turns to it
    private final BucketQueue across = new BucketQueue(); // the same across the corner that is left of that side
    private @Nullable Guide guide;
    private boolean blocked; // some cells, unlike in the map
    private int front; // the next bucket, as costs in the field
    private int lowest; // of the cells that passed the wave on or are blocked unlike in the map
    private int highest;

    /// The least that a way from a cell on to where the wave hurries can cost; between neighbors it differs by no
    /// more than the step (it is consistent), and it is 0 there.
    @FunctionalInterface
    interface Guide {
        int least(int cell);
    }

    /// Ways get longer than a wave can count. What it reached before stays as it is.
    static final class TooFar extends RuntimeException {
        private static final long serialVersionUID = 1;

        private TooFar(String why) {
            super(why);
        }

        /// In words for people.
        String why() {
            return String.valueOf(getMessage());
        }
    }

    Wave(CostMap map) {
        this(map, new int[map.ground().length]);
        blockAsOnMap();
    }

    /// @param field what each cell holds; where the map is blocked only, it is not looked at beside what is open
    private Wave(CostMap map, int[] field) {
        this.map = map;
        this.ground = map.ground();
        this.width = map.grid().width();
        this.field = field;
        this.steps = new int[] {1, width, -1, -width, 1};
        this.lowest = 0;
        this.highest = field.length - 1;
    }

    CostMap map() {
        return map;
    }

    /// The same wave over another map, which knows at least as much: what differs is mended, the rest is kept. Not for
    /// one that is hurried or for which cells were blocked. Whatever comes of it, this one is not to be used any
    /// more.
    ///
    /// @param changes of its map, which stays open where the wave comes from
    /// @return empty when a new one is sooner where it is wanted
    Optional<Wave> over(CostChanges changes) {
        boolean isDone = along.isEmpty() && across.isEmpty();
        int until = Math.min(front, FARTHEST + 1); // a new one would not get farther
        var mending = new IncrementalRepair(changes, field, isDone ? OPEN : until);
        if (mending.gaveUp()) {
            return Optional.empty();
        }
        var mended = new Wave(changes.to(), mending.field());
        mended.goOn(mending.borders(), until);
        return Optional.of(mended);
    }

    /// Passes on what cells hold, in every direction.
    ///
    /// @param borders such cells as [IncrementalRepair#borders] has them
    /// @param until from here on it spreads when it is asked to
    private void goOn(long[] borders, int until) {
        front = until;
        if (borders.length > 0) {
            front = IncrementalRepair.value(borders[0]);
        }
        int next = 0;
        while (next < borders.length || front < until) {
            for (; next < borders.length && IncrementalRepair.value(borders[next]) == front; next++) {
                passOnAround(IncrementalRepair.cell(borders[next]));
            }
            expand();
            front++;
        }
    }

    /// Forgets where it was and what was blocked.
    void clear() {
        along.forEach(this::touched);
        across.forEach(this::touched);
        along.clear();
        across.clear();
        if (lowest <= highest) {
            Arrays.fill(field, lowest, highest + 1, OPEN);
            blockAsOnMap();
        }
        blocked = false;
    }

    private void blockAsOnMap() {
        int[] shore = map.shore();
        int from = Arrays.binarySearch(shore, lowest);
        for (int i = from < 0 ? -from - 1 : from; i < shore.length && shore[i] <= highest; i++) {
            field[shore[i]] = BLOCKED;
        }
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
        field[source] = SOURCE;
        front = SOURCE + least(source);
        passOnAround(source);
    }

    /// Lets a cell of the next bucket pass the wave on in every direction.
    private void passOnAround(int cell) {
        along.push(front, cell, 0); // as if it had been reached
        along.push(front, cell, 2); // from either side
    }

    /// Spreads on until it is known what the way to a cell costs.
    ///
    /// @param target −1 lets it reach everything
    /// @return whether it reaches the target
    /// @throws TooFar when ways get longer than it can count
    boolean spread(int target) {
        int empty = 0; // buckets in a row
        while (empty < BUCKETS && (target < 0 || field[target] == OPEN || field[target] >= front)) {
            empty = along.isEmpty(front) && across.isEmpty(front) ? empty + 1 : 0;
            if (empty == 0 && front > FARTHEST) {
                throw tooFar();
            }
            expand();
            front++;
        }
        if (empty == BUCKETS) {
            front -= BUCKETS; // nothing is left to pass on, however often it is asked
        }
        return target >= 0 && field[target] != OPEN;
    }

    private TooFar tooFar() {
        return new TooFar("""
                Ways over a map of (%d × %d) cells get too long: they cost more than %d cells far from everything.
                Maybe the map can be drawn with larger cells, or the robot be given a smaller clearance.""".formatted(width, field.length / width, (FARTHEST - SOURCE) / SIDE));
    }

    /// What the way between an open cell and the source costs. Without a guide it is final if it costs less than what
    /// is [#known].
    int at(int cell) {
        return field[cell] == OPEN ? UNREACHED : field[cell] - SOURCE;
    }

    boolean isOpen(int cell) {
        return map.isOpen(cell) && field[cell] >= SOURCE;
    }

    /// All ways that cost less are known.
    int known() {
        return front - SOURCE;
    }

    /// The neighbor from which the wave came; of several the first by row, then column; −1 at the source.
    int towardsSource(int cell) {
        int best = -1;
        int least = OPEN;
        for (int dy = -1; dy <= 1; dy++) {
            for (int dx = -1; dx <= 1; dx++) {
                int next = cell + dy * width + dx;
                boolean diagonal = dx != 0 && dy != 0;
                boolean corner = diagonal && (field[cell + dx] < SOURCE || field[cell + dy * width] < SOURCE);
                if (corner || field[next] < SOURCE || field[next] >= field[cell]) {
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
        int alongDone = 0;
        int acrossDone = 0;
        while (alongDone < along.count(front) || acrossDone < across.count(front)) {
            int alongCount = along.count(front);
            int acrossCount = across.count(front);
            expandAlong(along.entries(front), alongDone, alongCount);
            expandAcross(across.entries(front), acrossDone, acrossCount);
            alongDone = alongCount;
            acrossDone = acrossCount;
        }
        along.empty(front);
        across.empty(front);
    }

    /// Lets cells that were reached along a side pass the wave on: ahead, to the left, to the right and between these.
    private void expandAlong(int[] entries, int from, int to) {
        int[] field = this.field; // the compiler would look them up again after each step
        byte[] ground = this.ground;
        for (int i = from; i < to; i++) {
            int cell = BucketQueue.cell(entries[i]);
            int quarter = BucketQueue.quarter(entries[i]);
            int reached = field[cell];
            touched(cell);
            if (reached + least(cell) != front) {
                continue; // was reached for less since
            }
            int ahead = cell + steps[quarter];
            int left = cell + steps[quarter + 1];
            int right = cell - steps[quarter + 1];
            int leftAhead = left + steps[quarter];
            int rightAhead = right + steps[quarter];
            int most = reached + RUN;
            int half = CostMap.cost(ground[cell]); // of a step along a side
            straight(field, ahead, quarter, reached + half, most);
            straight(field, left, quarter + 1, reached + half, most);
            straight(field, right, quarter + 3, reached + half, most);
            if (field[ahead] >= SOURCE) {
                diagonal(field, leftAhead, left, quarter, reached, half, most);
                diagonal(field, rightAhead, right, quarter + 3, reached, half, most);
            }
        }
    }

    /// Lets cells that were reached across a corner pass the wave on: ahead, to both sides and between these.
    private void expandAcross(int[] entries, int from, int to) {
        int[] field = this.field; // the compiler would look them up again after each step
        byte[] ground = this.ground;
        for (int i = from; i < to; i++) {
            int cell = BucketQueue.cell(entries[i]);
            int quarter = BucketQueue.quarter(entries[i]);
            int reached = field[cell];
            touched(cell);
            if (reached + least(cell) != front) {
                continue; // was reached for less since
            }
            int right = cell + steps[quarter];
            int left = cell + steps[quarter + 1];
            int ahead = left + steps[quarter];
            int farRight = right - steps[quarter + 1];
            int farLeft = left - steps[quarter];
            int most = reached + RUN;
            int half = CostMap.cost(ground[cell]); // of a step along a side
            straight(field, right, quarter, reached + half, most);
            straight(field, left, quarter + 1, reached + half, most);
            if (field[left] >= SOURCE) {
                diagonal(field, ahead, right, quarter, reached, half, most);
            }
            diagonal(field, farLeft, left, quarter + 1, reached, half, most);
            diagonal(field, farRight, right, quarter + 3, reached, half, most);
        }
    }

    /// Reaches a cell along a side and, over plains, those behind it that cost no more than `most`.
    ///
    /// @param border what it costs to get to the side
    private void straight(int[] field, int cell, int turns, int border, int most) {
        byte[] ground = this.ground;
        int now = border + CostMap.cost(ground[cell]);
        if (now < field[cell]) {
            if (ground[cell] == CostMap.PLAIN) {
                run(field, cell, turns & 3, now, most);
            } else {
                field[cell] = now;
                along.push(now + least(cell), cell, turns & 3);
            }
        }
    }

    /// Reaches a cell across a corner and, over plains, those behind it and beside these; not if the one beside it, at
    /// the same corner, is blocked or reaches it for no more.
    ///
    /// @param half of what a step along a side costs, of the cell from which it is reached
    private void diagonal(int[] field, int cell, int beside, int turns, int reached, int half, int most) {
        byte[] ground = this.ground;
        int otherHalf = CostMap.cost(ground[cell]);
        int now = reached + CostMap.diagonal(half + otherHalf);
        if (now < field[beside] + CostMap.cost(ground[beside]) + otherHalf && now < field[cell]) {
            if (ground[cell] == CostMap.PLAIN) {
                diagonalRun(field, cell, turns & 3, now, most);
            } else {
                field[cell] = now;
                across.push(now + least(cell), cell, turns & 3);
            }
        }
    }

    private void run(int[] field, int first, int quarter, int cost, int most) {
        byte[] ground = this.ground;
        int step = steps[quarter];
        int cell = first;
        int now = cost;
        while (now < field[cell]) {
            field[cell] = now;
            if (ground[cell] != CostMap.PLAIN || now > most || blocked) {
                along.push(now + least(cell), cell, quarter);
                break;
            }
            cell += step;
            now += SIDE;
        }
    }

    private void diagonalRun(int[] field, int first, int quarter, int cost, int most) {
        int right = steps[quarter];
        int left = steps[quarter + 1];
        int far = most - RUN + DIAGONAL_RUN;
        int cell = first;
        int now = cost;
        while (now < field[cell]) {
            field[cell] = now;
            if (ground[cell] != CostMap.PLAIN || now > far || blocked) {
                across.push(now + least(cell), cell, quarter);
                break;
            }
            run(field, cell + right, quarter, now + SIDE, most);
            run(field, cell + left, (quarter + 1) & 3, now + SIDE, most);
            cell += right + left;
            now += DIAGONAL;
        }
    }

    private void touched(int cell) {
        lowest = Math.min(lowest, cell);
        highest = Math.max(highest, cell);
    }

    private int least(int cell) {
        return guide == null ? 0 : guide.least(cell);
    }
}
