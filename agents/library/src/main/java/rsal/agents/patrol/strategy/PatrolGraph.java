package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

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
    /// @throws IllegalArgumentException when there is no place or too many, or an edge is none
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

    /// The neighbor of a place that comes first on the shortest path to another; the other itself when none
    /// lies on it.
    public int firstStep(int from, int to) {
        double direct = length(from, to) * (1 + 1e-9);
        for (int next : neighbors[from]) {
            if (next != to && length(from, next) + length(next, to) <= direct && length(next, to) < length(from, to)) {
                return next;
            }
        }
        return to;
    }
}
