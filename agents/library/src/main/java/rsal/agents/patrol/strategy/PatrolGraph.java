package rsal.agents.patrol.strategy;

import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;
import java.util.stream.IntStream;

/// Places to visit, the lengths of the shortest paths between them, and which of them are neighbors. Places
/// have the numbers from 0. Immutable.
public final class PatrolGraph {
    /// Largest number of places.
    public static final int MOST = 1000;

    private static final double BETWEEN = 1.05; // a path over a place that lies between may be longer by this factor

    private final int size;
    private final double[] lengths; // m, row-major
    private final int[][] neighbors; // in ascending order
    private final double speed;
    private final double stop;

    private PatrolGraph(int size, double[] lengths, int[][] neighbors, double speed, double stop) {
        this.size = size;
        this.lengths = lengths;
        this.neighbors = neighbors;
        this.speed = speed;
        this.stop = stop;
    }

    /// An edge that robots can drive both ways.
    ///
    /// @param length [m], positive
    public record Edge(int from, int to, double length) {}

    /// From path lengths. Two places are neighbors when no third place lies between them, which is when a path
    /// over it would be at most 5 % longer.
    ///
    /// @param lengths row-major, size × size [m]; +∞ where no path leads; handed over
    /// @param speed of the robots [m/s]
    /// @param stop time that a robot loses at each place [s]
    /// @throws IllegalArgumentException when there is no place or too many, or a length is negative or NaN
    public static PatrolGraph ofLengths(double[] lengths, double speed, double stop) {
        int size = (int) Math.round(Math.sqrt(lengths.length));
        check(size, speed, stop);
        if (size * size != lengths.length || Arrays.stream(lengths).anyMatch(length -> !(length >= 0))) {
            throw new IllegalArgumentException(
                    "Path lengths must be a square matrix of numbers that are not negative, not %d values."
                            .formatted(lengths.length));
        }
        var neighbors = new int[size][];
        for (int from = 0; from < size; from++) {
            var next = new ArrayList<Integer>();
            for (int to = 0; to < size; to++) {
                if (from != to && Double.isFinite(lengths[from * size + to]) && isDirect(lengths, size, from, to)) {
                    next.add(to);
                }
            }
            neighbors[from] = next.stream().mapToInt(Integer::intValue).toArray();
        }
        return new PatrolGraph(size, lengths, neighbors, speed, stop);
    }

    private static boolean isDirect(double[] lengths, int size, int from, int to) {
        double direct = lengths[from * size + to];
        for (int via = 0; via < size; via++) {
            double first = lengths[from * size + via];
            double second = lengths[via * size + to];
            if (via != from && via != to && first < direct && second < direct && first + second <= BETWEEN * direct) {
                return false;
            }
        }
        return true;
    }

    /// From edges between neighbors; a path's length is the sum of its edges.
    ///
    /// @param speed of the robots [m/s]
    /// @param stop time that a robot loses at each place [s]
    /// @throws IllegalArgumentException when there is no place or too many, or an edge is invalid
    public static PatrolGraph ofEdges(int size, List<Edge> edges, double speed, double stop) {
        check(size, speed, stop);
        var out = new ArrayList<List<Edge>>();
        for (int place = 0; place < size; place++) {
            out.add(new ArrayList<>());
        }
        for (Edge edge : edges) {
            if (edge.from < 0 || edge.from >= size || edge.to < 0 || edge.to >= size || edge.from == edge.to) {
                throw new IllegalArgumentException(
                        "An edge leads from place %d to place %d; there are %d places from 0."
                                .formatted(edge.from, edge.to, size));
            }
            if (!(edge.length > 0) || Double.isInfinite(edge.length)) {
                throw new IllegalArgumentException("The edge from place %d to place %d has the length %s m."
                        .formatted(edge.from, edge.to, edge.length));
            }
            out.get(edge.from).add(edge);
            out.get(edge.to).add(new Edge(edge.to, edge.from, edge.length));
        }
        var lengths = new double[size * size];
        var neighbors = new int[size][];
        for (int place = 0; place < size; place++) {
            search(out, place, lengths, size);
            neighbors[place] = out.get(place).stream()
                    .mapToInt(Edge::to)
                    .distinct()
                    .sorted()
                    .toArray();
        }
        return new PatrolGraph(size, lengths, neighbors, speed, stop);
    }

    private record Reached(int place, double length) {}

    /// Shortest paths from one place to all: Dijkstra, "A note on two problems in connexion with graphs"
    /// (1959).
    private static void search(List<List<Edge>> out, int start, double[] lengths, int size) {
        int row = start * size;
        Arrays.fill(lengths, row, row + size, Double.POSITIVE_INFINITY);
        lengths[row + start] = 0;
        var open = new PriorityQueue<Reached>(Comparator.comparingDouble(Reached::length));
        open.add(new Reached(start, 0));
        while (!open.isEmpty()) {
            Reached here = open.poll();
            if (here.length > lengths[row + here.place]) {
                continue;
            }
            for (Edge edge : out.get(here.place)) {
                double length = here.length + edge.length;
                if (length < lengths[row + edge.to]) {
                    lengths[row + edge.to] = length;
                    open.add(new Reached(edge.to, length));
                }
            }
        }
    }

    private static void check(int size, double speed, double stop) {
        if (size < 1 || size > MOST) {
            throw new IllegalArgumentException("A patrol has 1 to %d places, not %d.".formatted(MOST, size));
        }
        if (!(speed > 0) || !(stop >= 0)) {
            throw new IllegalArgumentException(
                    "Robots need a speed above 0 and a time per stop of at least 0, not %s m/s and %s s."
                            .formatted(speed, stop));
        }
    }

    /// The same places for other robots.
    public PatrolGraph with(double newSpeed, double newStop) {
        check(size, newSpeed, newStop);
        return new PatrolGraph(size, lengths, neighbors, newSpeed, newStop);
    }

    public int size() {
        return size;
    }

    /// Of the robots [m/s].
    public double speed() {
        return speed;
    }

    /// Time that a robot loses at each place [s].
    public double stop() {
        return stop;
    }

    /// Of the shortest path [m]; +∞ when there is none.
    public double length(int from, int to) {
        return lengths[from * size + to];
    }

    /// Time from leaving a place until leaving another [s].
    public double time(int from, int to) {
        return lengths[from * size + to] / speed + stop;
    }

    /// In ascending order; not to be written to.
    int[] neighbors(int place) {
        return neighbors[place];
    }

    /// The places next to a place, in ascending order.
    public int[] neighborsOf(int place) {
        return neighbors[place].clone();
    }

    /// The neighbor of a place that comes first on the shortest path to another; the other itself when it is a
    /// neighbor and no third place lies exactly on the path.
    public int firstStep(int from, int to) {
        double direct = length(from, to) * (1 + 1e-9);
        int best = to;
        double least = Arrays.binarySearch(neighbors[from], to) >= 0 ? direct : Double.POSITIVE_INFINITY;
        for (int next : neighbors[from]) {
            double over = length(from, next) + length(next, to);
            if (next != to && length(next, to) < length(from, to) && over <= least) {
                if (over <= direct) {
                    return next;
                }
                best = over < least ? next : best;
                least = over;
            }
        }
        return best;
    }

    /// For each place, how many edges between neighbors lie on the way with the fewest; as many as there are
    /// places when none leads there.
    int[] hops(int from) {
        var hops = new int[size];
        Arrays.fill(hops, size);
        hops[from] = 0;
        var queue = new int[size];
        queue[0] = from;
        int end = 1;
        for (int i = 0; i < end; i++) {
            for (int next : neighbors[queue[i]]) {
                if (hops[next] == size && next != from) {
                    hops[next] = hops[queue[i]] + 1;
                    queue[end++] = next;
                }
            }
        }
        return hops;
    }

    /// The most places that can be reached from each other, in ascending order; of several such sets, the one
    /// with the least place.
    public int[] largestPart() {
        int[] best = {};
        var done = new boolean[size];
        for (int start = 0; start < size; start++) {
            if (!done[start]) {
                int[] part = part(start);
                Arrays.stream(part).forEach(place -> done[place] = true);
                best = part.length > best.length ? part : best;
            }
        }
        return best;
    }

    /// Places that a path leads to, perhaps over others.
    private int[] part(int start) {
        var reached = new boolean[size];
        reached[start] = true;
        var open = new ArrayDeque<Integer>(List.of(start));
        while (!open.isEmpty()) {
            int here = open.remove();
            for (int next = 0; next < size; next++) {
                if (!reached[next] && Double.isFinite(length(here, next))) {
                    reached[next] = true;
                    open.add(next);
                }
            }
        }
        return IntStream.range(0, size).filter(place -> reached[place]).toArray();
    }

    /// Some of the places, numbered from 0 in the order given. Where no path is known between two of them, it
    /// leads over others of them, if it can.
    public PatrolGraph only(int[] places) {
        int count = places.length;
        var some = new double[count * count];
        boolean open = false;
        for (int from = 0; from < count; from++) {
            for (int to = 0; to < count; to++) {
                some[from * count + to] = length(places[from], places[to]);
                open |= Double.isInfinite(some[from * count + to]);
            }
        }
        if (open) {
            close(some, count);
        }
        return ofLengths(some, speed, stop);
    }

    /// Shortest paths where none is known: R. Floyd, "Algorithm 97: Shortest path" (1962).
    private static void close(double[] lengths, int size) {
        var unknown = new boolean[lengths.length];
        for (int i = 0; i < lengths.length; i++) {
            unknown[i] = Double.isInfinite(lengths[i]);
        }
        for (int via = 0; via < size; via++) {
            for (int from = 0; from < size; from++) {
                double first = lengths[from * size + via];
                for (int to = 0; to < size; to++) {
                    double over = first + lengths[via * size + to];
                    int pair = from * size + to;
                    lengths[pair] = unknown[pair] ? Math.min(lengths[pair], over) : lengths[pair];
                }
            }
        }
    }
}
