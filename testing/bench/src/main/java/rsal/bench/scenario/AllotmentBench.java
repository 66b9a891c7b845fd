package rsal.bench.scenario;

import static java.util.Objects.requireNonNull;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.SortedMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.function.DoubleBinaryOperator;
import java.util.function.ToDoubleFunction;
import java.util.stream.DoubleStream;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import rsal.agent.team.Estimate;
import rsal.agent.team.JobRoutes;
import rsal.agent.team.Objective;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.place.Office;
import rsal.data.Point2d;
import rsal.engine.report.RunResult;
import rsal.engine.report.TopicTraffic;
import rsal.navigation.grid.DistanceField;
import rsal.navigation.spread.ReachableSpace;
import rsal.navigation.spread.Spreader;
import rsal.navigation.wavefront.CostMap;
import rsal.navigation.wavefront.Wavefront;
import rsal.scenario.RunOptions;
import rsal.scenario.Scenario;

/// How well a team's jobs are allotted by what its members bid, beside the best there is, found by trying everything:
/// members and jobs anywhere in a square of 100 m, drawn from the seeds 1, 2, 3, ….
///
/// Names are `allot.<what>.ratio`, the mean of all draws, and `.worst`. What: `single`, as many members as jobs and one
/// job each, by the sum; `routes.sum` and `routes.longest`, 8 to 10 jobs among 1 to 4 members, by the sum and by the
/// longest route; `places.sum` and `places.longest`, 2 to 8 robots anywhere on the office floor and as many places
/// spread over it, allotted as the scenario `distribution` does, by the sum of the ways and by the longest
/// ([rsal.agent.team.Assignment#even]). And `allot.messages`, how many messages a team needs for a job, all told, in
/// whole runs of `patrol` by bids.
public final class AllotmentBench implements Bench {
    private static final int DRAWS = 100;
    private static final double SIDE = 100; // m
    private static final String SINGLE = "allot.single";
    private static final String PLACES_SUM = "allot.places.sum";
    private static final String PLACES_LONGEST = "allot.places.longest";
    private static final double CLEARANCE = 0.4; // m
    private static final double SLACK = 0.5; // m
    private static final String MESSAGES = "allot.messages";
    private static final Scenario PATROL = Scenario.load("patrol");

    private static String routes(Objective objective) {
        return objective == Objective.SUM ? "allot.routes.sum" : "allot.routes.longest";
    }

    private static List<String> ratios(String name) {
        return List.of(name + ".ratio", name + ".worst");
    }

    @Override
    public List<String> names() {
        var names = new ArrayList<>(ratios(SINGLE));
        names.addAll(ratios(routes(Objective.SUM)));
        names.addAll(ratios(routes(Objective.LONGEST)));
        names.addAll(ratios(PLACES_SUM));
        names.addAll(ratios(PLACES_LONGEST));
        names.add(MESSAGES);
        return names;
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        if (assignment.wantsAny(ratios(SINGLE))) {
            report(SINGLE, draws(AllotmentBench::single), assignment);
        }
        for (Objective objective : List.of(Objective.SUM, Objective.LONGEST)) {
            if (assignment.wantsAny(ratios(routes(objective)))) {
                report(routes(objective), draws(random -> inRoutes(random, objective)), assignment);
            }
        }
        if (assignment.wantsAny(ratios(PLACES_SUM)) || assignment.wantsAny(ratios(PLACES_LONGEST))) {
            List<NavigableMap<String, double[]>> floors = floors();
            report(PLACES_SUM, even(floors, Double::sum), assignment);
            report(PLACES_LONGEST, even(floors, Math::max), assignment);
        }
        if (assignment.wants(MESSAGES)) {
            List<RunResult> runs = SeededRuns.of(
                    "allot.patrol", PATROL, RunOptions.NONE.withArguments(Map.of("strategy", "bids")), assignment);
            assignment.report(Result.less(
                    MESSAGES,
                    "",
                    runs.stream().mapToDouble(AllotmentBench::messagesForAJob).toArray()));
        }
    }

    private static double[] draws(ToDoubleFunction<SplittableRandom> ratio) {
        return IntStream.rangeClosed(1, DRAWS)
                .mapToDouble(seed -> ratio.applyAsDouble(new SplittableRandom(seed)))
                .toArray();
    }

    private static void report(String name, double[] ratios, BenchmarkRequest assignment) {
        Result all = Result.less(name + ".ratio", "", ratios);
        assignment.report(
                all.withValue(DoubleStream.of(ratios).average().orElseThrow()), all.at(name + ".worst", all.most()));
    }

    private static double messagesForAJob(RunResult run) {
        return (double) said(run, "work") / said(run, "visited");
    }

    private static long said(RunResult run, String topic) {
        return run.topics().stream()
                .filter(one -> one.topic().equals(topic))
                .mapToLong(TopicTraffic::said)
                .sum();
    }

    private static double single(SplittableRandom random) {
        int size = random.nextInt(2, 9);
        NavigableMap<String, Estimate> members = anywhere(random, size, size);
        var costs = new TreeMap<String, double[]>();
        members.forEach((name, estimate) -> costs.put(
                name, estimate.first().stream().mapToDouble(Double::doubleValue).toArray()));
        return ratio(costs, rsal.agent.team.Assignment.cheapest(costs), Double::sum);
    }

    /// What ways to places spread over the office floor cost robots anywhere on it, by draw.
    private static List<NavigableMap<String, double[]>> floors() {
        var ground = ReachableSpace.largest(Office.MAP, CLEARANCE);
        var wavefront = new Wavefront(CostMap.of(
                Office.MAP, DistanceField.toNotFree(Office.MAP), new CostMap.Clearance(CLEARANCE, 2 * CLEARANCE, 3)));
        return LongStream.rangeClosed(1, DRAWS)
                .mapToObj(seed -> floor(new SplittableRandom(seed), ground, wavefront))
                .toList();
    }

    private static NavigableMap<String, double[]> floor(
            SplittableRandom random, ReachableSpace ground, Wavefront wavefront) {
        int size = random.nextInt(2, 9);
        List<Point2d> places =
                new Spreader(ground, size).spread(random, _ -> {}).places();
        var costs = new TreeMap<String, double[]>();
        for (int robot = 0; robot < size; robot++) {
            Point2d start = Office.place(random, ground::contains).position();
            costs.put(
                    "r" + robot,
                    wavefront.costs(start, places, SLACK).stream()
                            .mapToDouble(Double::doubleValue)
                            .toArray());
        }
        return costs;
    }

    private static double[] even(List<NavigableMap<String, double[]>> floors, DoubleBinaryOperator joined) {
        return floors.stream()
                .mapToDouble(costs -> ratio(costs, rsal.agent.team.Assignment.even(costs), joined))
                .toArray();
    }

    /// What is allotted by the best that could be.
    private static double ratio(
            NavigableMap<String, double[]> costs, Map<String, Integer> allotted, DoubleBinaryOperator joined) {
        double cost = allotted.entrySet().stream()
                .mapToDouble(pair -> requireNonNull(costs.get(pair.getKey()))[pair.getValue()])
                .reduce(0, joined);
        return cost / best(List.copyOf(costs.values()), joined, 0, 0);
    }

    /// Gives each member each job that is left.
    private static double best(List<double[]> costs, DoubleBinaryOperator joined, int member, int given) {
        if (member == costs.size()) {
            return 0;
        }
        double best = Double.POSITIVE_INFINITY;
        for (int job = 0; job < costs.size(); job++) {
            if ((given & 1 << job) == 0) {
                double others = best(costs, joined, member + 1, given | 1 << job);
                best = Math.min(best, joined.applyAsDouble(costs.get(member)[job], others));
            }
        }
        return best;
    }

    private static double inRoutes(SplittableRandom random, Objective objective) {
        NavigableMap<String, Estimate> members = anywhere(random, random.nextInt(1, 5), random.nextInt(8, 11));
        SortedMap<String, List<Integer>> divided = JobRoutes.divide(members, objective);
        DoubleStream costs = divided.entrySet().stream()
                .mapToDouble(route -> JobRoutes.cost(requireNonNull(members.get(route.getKey())), route.getValue()));
        double value = objective == Objective.SUM ? costs.sum() : costs.max().orElse(0);
        return value / best(members, objective);
    }

    /// Divides all sets of jobs in all ways among more and more members.
    private static double best(NavigableMap<String, Estimate> members, Objective objective) {
        double[] best = null; // for the members so far, by set of jobs
        for (Estimate member : members.values()) {
            double[] alone = shortest(member);
            if (best == null) {
                best = alone;
                continue;
            }
            var together = new double[alone.length];
            for (int all = 0; all < alone.length; all++) {
                together[all] = best[all];
                for (int own = all; own > 0; own = (own - 1) & all) {
                    double others = best[all ^ own];
                    double both = objective == Objective.SUM ? others + alone[own] : Math.max(others, alone[own]);
                    together[all] = Math.min(together[all], both);
                }
            }
            best = together;
        }
        if (best == null) {
            throw new IllegalArgumentException("Nobody is there.");
        }
        return best[best.length - 1];
    }

    /// Shortest routes of one member by set of jobs: M. Held, R. Karp, A Dynamic Programming Approach to Sequencing
    /// Problems (1962).
    private static double[] shortest(Estimate member) {
        int jobs = member.first().size();
        var ending = new double[1 << jobs][jobs]; // by set and the last of them
        var shortest = new double[1 << jobs];
        for (int set = 1; set < shortest.length; set++) {
            Arrays.fill(ending[set], Double.POSITIVE_INFINITY);
            shortest[set] = Double.POSITIVE_INFINITY;
            for (int last = 0; last < jobs; last++) {
                if ((set & 1 << last) == 0) {
                    continue;
                }
                int before = set ^ 1 << last;
                if (before == 0) {
                    ending[set][last] = member.first().get(last);
                }
                for (int previous = 0; previous < jobs; previous++) {
                    if ((before & 1 << previous) != 0) {
                        double cost = ending[before][previous]
                                + member.after().get(previous).get(last);
                        ending[set][last] = Math.min(ending[set][last], cost);
                    }
                }
                shortest[set] = Math.min(shortest[set], ending[set][last]);
            }
        }
        return shortest;
    }

    private static NavigableMap<String, Estimate> anywhere(SplittableRandom random, int members, int jobs) {
        List<Point2d> places = Stream.generate(() -> new Point2d(random.nextDouble(SIDE), random.nextDouble(SIDE)))
                .limit(members + jobs)
                .toList();
        var estimates = new TreeMap<String, Estimate>();
        for (int member = 0; member < members; member++) {
            estimates.put("m" + member, Estimate.straight(places.get(member), places.subList(members, places.size())));
        }
        return estimates;
    }
}
