package rsal.agents.patrol.strategy;

import java.util.Arrays;

/// Short closed tours over places: by nearest neighbors from several starts, then 2-opt (G. Croes, "A method
/// for solving traveling-salesman problems", 1958) and or-opt (I. Or, 1976), which moves up to three places in
/// a row elsewhere.
final class Tours {
    private static final int STARTS = 6;
    private static final int PASSES = 60;
    private static final double GAIN = 1e-9; // s

    private Tours() {}

    /// Time of one round [s], with a stop at each place.
    static double time(PatrolGraph graph, int[] tour) {
        double sum = 0;
        for (int i = 0; i < tour.length; i++) {
            sum += graph.time(tour[i], tour[(i + 1) % tour.length]);
        }
        return sum;
    }

    /// A short tour over places, beginning with the first of them that is given.
    static int[] over(PatrolGraph graph, int[] places) {
        if (places.length < 3) {
            return places.clone();
        }
        int[] best = {};
        double least = Double.POSITIVE_INFINITY;
        int starts = Math.min(STARTS, places.length);
        for (int i = 0; i < starts; i++) {
            int[] tour = nearestNext(graph, places, i * places.length / starts);
            improve(graph, tour);
            double time = time(graph, tour);
            if (best.length == 0 || time < least - GAIN) {
                least = time;
                best = tour;
            }
        }
        return best;
    }

    private static int[] nearestNext(PatrolGraph graph, int[] places, int start) {
        int[] tour = places.clone();
        swap(tour, 0, start);
        for (int i = 1; i < tour.length; i++) {
            int nearest = i;
            for (int j = i + 1; j < tour.length; j++) {
                if (graph.length(tour[i - 1], tour[j]) < graph.length(tour[i - 1], tour[nearest])) {
                    nearest = j;
                }
            }
            swap(tour, i, nearest);
        }
        return tour;
    }

    private static void swap(int[] values, int i, int j) {
        int value = values[i];
        values[i] = values[j];
        values[j] = value;
    }

    /// Shortens a tour in place until neither change helps.
    static void improve(PatrolGraph graph, int[] tour) {
        boolean better = tour.length > 3;
        for (int pass = 0; better && pass < PASSES; pass++) {
            boolean reversed = reverse(graph, tour);
            better = move(graph, tour) || reversed;
        }
    }

    /// Turns a part of the tour around where that is shorter.
    private static boolean reverse(PatrolGraph graph, int[] tour) {
        boolean better = false;
        int n = tour.length;
        for (int i = 0; i < n - 1; i++) {
            for (int j = i + 1; j < n; j++) {
                int before = tour[(i + n - 1) % n];
                int after = tour[(j + 1) % n];
                if (before == tour[j]) {
                    continue; // the whole tour
                }
                double gain = graph.length(before, tour[i])
                        + graph.length(tour[j], after)
                        - graph.length(before, tour[j])
                        - graph.length(tour[i], after);
                if (gain > GAIN) {
                    for (int a = i, b = j; a < b; a++, b--) {
                        swap(tour, a, b);
                    }
                    better = true;
                }
            }
        }
        return better;
    }

    /// Puts up to three places in a row elsewhere, where that is shorter.
    private static boolean move(PatrolGraph graph, int[] tour) {
        int n = tour.length;
        for (int row = 1; row <= Math.min(3, n - 2); row++) {
            for (int i = 0; i + row <= n; i++) {
                int first = tour[i];
                int last = tour[i + row - 1];
                int before = tour[(i + n - 1) % n];
                int after = tour[(i + row) % n];
                double out = graph.length(before, first) + graph.length(last, after) - graph.length(before, after);
                int[] rest = without(tour, i, row);
                for (int j = 0; j < rest.length; j++) {
                    int from = rest[j];
                    int to = rest[(j + 1) % rest.length];
                    double in = graph.length(from, first) + graph.length(last, to) - graph.length(from, to);
                    if (out - in > GAIN) {
                        int[] moved = with(rest, j + 1, Arrays.copyOfRange(tour, i, i + row));
                        System.arraycopy(moved, 0, tour, 0, n);
                        return true;
                    }
                }
            }
        }
        return false;
    }

    /// The same without some places in a row.
    static int[] without(int[] tour, int from, int count) {
        var rest = new int[tour.length - count];
        System.arraycopy(tour, 0, rest, 0, from);
        System.arraycopy(tour, from + count, rest, from, rest.length - from);
        return rest;
    }

    /// The same with places put in.
    static int[] with(int[] tour, int at, int... places) {
        var longer = new int[tour.length + places.length];
        System.arraycopy(tour, 0, longer, 0, at);
        System.arraycopy(places, 0, longer, at, places.length);
        System.arraycopy(tour, at, longer, at + places.length, tour.length - at);
        return longer;
    }

    /// Where a place lengthens a tour least when it is put in.
    static int slot(PatrolGraph graph, int[] tour, int place) {
        int best = tour.length;
        double least = Double.POSITIVE_INFINITY;
        for (int i = 0; i < tour.length; i++) {
            int next = tour[(i + 1) % tour.length];
            double more = graph.length(tour[i], place) + graph.length(place, next) - graph.length(tour[i], next);
            if (more < least) {
                least = more;
                best = i + 1;
            }
        }
        return best;
    }
}
