package rsal.agent.team;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SortedMap;
import java.util.TreeMap;

/// The best of all divisions of a few jobs, by dynamic programming over sets of jobs: first each member's best route
/// through each set (M. Held and R. M. Karp, "A dynamic programming approach to sequencing problems", 1962), then the
/// best way to give each set to the first members. Takes members · (2ⁿ n² + 3ⁿ) steps for n jobs.
final class ExactRoutes {
    /// More jobs take too long: 0.1 ms a member for 8, three times as long for each more.
    static final int MOST_JOBS = 8;

    private final Objective objective;
    private final List<String> names;
    private final Estimate[] estimates;
    private final int jobs;
    private final int sets;

    private ExactRoutes(SortedMap<String, Estimate> members, Objective objective) {
        this.objective = objective;
        this.names = List.copyOf(members.keySet());
        this.estimates = members.values().toArray(Estimate[]::new);
        this.jobs = estimates[0].first().size();
        this.sets = 1 << jobs;
    }

    /// As [JobRoutes#divide] has it.
    static SortedMap<String, List<Integer>> divide(SortedMap<String, Estimate> members, Objective objective) {
        return new ExactRoutes(members, objective).divide();
    }

    private SortedMap<String, List<Integer>> divide() {
        var best = new double[estimates.length][][]; // cost of a set in any order that ends with a job
        var reached = new double[estimates.length + 1][sets]; // what sets cost the first members
        var part = new int[estimates.length][sets]; // that the last of them does
        Arrays.fill(reached[0], Double.POSITIVE_INFINITY);
        reached[0][0] = 0;
        for (int member = 0; member < estimates.length; member++) {
            best[member] = routesOf(estimates[member]);
            double[] route = shortest(best[member]);
            for (int set = 0; set < sets; set++) {
                reached[member + 1][set] = reached[member][set]; // it does nothing
                for (int mine = set; mine > 0; mine = (mine - 1) & set) {
                    double total = together(reached[member][set & ~mine], route[mine]);
                    if (total < reached[member + 1][set]) {
                        reached[member + 1][set] = total;
                        part[member][set] = mine;
                    }
                }
            }
        }
        return follow(best, part, mostJobs(reached[estimates.length]));
    }

    private double together(double others, double mine) {
        return objective == Objective.SUM
                ? others + mine
                : Math.max(others, mine) + JobRoutes.SUM_IN_LONGEST * (others + mine);
    }

    /// Of all sets that can be done one with most jobs, of those the cheapest.
    private int mostJobs(double[] total) {
        int most = 0;
        for (int set = 1; set < sets; set++) {
            int more = Integer.bitCount(set) - Integer.bitCount(most);
            boolean better = more > 0 || (more == 0 && total[set] < total[most]);
            if (total[set] < Double.POSITIVE_INFINITY && better) {
                most = set;
            }
        }
        return most;
    }

    private SortedMap<String, List<Integer>> follow(double[][][] best, int[][] part, int all) {
        var divided = new TreeMap<String, List<Integer>>();
        int set = all;
        for (int member = estimates.length - 1; member >= 0; member--) {
            int mine = part[member][set];
            if (mine != 0) {
                divided.put(names.get(member), route(estimates[member], best[member], mine));
            }
            set &= ~mine;
        }
        return divided;
    }

    private double[][] routesOf(Estimate estimate) {
        var best = new double[sets][jobs];
        for (int set = 0; set < sets; set++) {
            for (int last = 0; last < jobs; last++) {
                best[set][last] = Double.POSITIVE_INFINITY;
                int before = set & ~(1 << last);
                if (before == 0 && set != 0) {
                    best[set][last] = estimate.first().get(last);
                } else if (before != set) {
                    for (int previous = 0; previous < jobs; previous++) {
                        double cost = best[before][previous]
                                + estimate.after().get(previous).get(last);
                        best[set][last] = Math.min(best[set][last], cost);
                    }
                }
            }
        }
        return best;
    }

    private static double[] shortest(double[][] endingWith) {
        return Arrays.stream(endingWith)
                .mapToDouble(costs -> Arrays.stream(costs).min().orElse(0))
                .toArray();
    }

    private List<Integer> route(Estimate estimate, double[][] best, int mine) {
        var backwards = new ArrayList<Integer>();
        int set = mine;
        while (set != 0) {
            int last = -1;
            double least = Double.POSITIVE_INFINITY;
            for (int job = 0; job < jobs; job++) {
                double on = backwards.isEmpty() ? 0 : estimate.after().get(job).get(backwards.getLast());
                if (best[set][job] + on < least) {
                    last = job;
                    least = best[set][job] + on;
                }
            }
            backwards.add(last);
            set &= ~(1 << last);
        }
        return List.copyOf(backwards.reversed());
    }
}
