package rsal.agent.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.List;
import java.util.NavigableMap;
import java.util.Set;
import java.util.SortedMap;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.condition.EnabledIfSystemProperty;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.Point2d;

class JobRoutesTest {
    /// Members and jobs anywhere in a square of 100 m.
    private static NavigableMap<String, Estimate> anywhere(SplittableRandom random, int members, int jobs) {
        List<Point2d> places = Stream.generate(() -> new Point2d(random.nextDouble(100), random.nextDouble(100)))
                .limit(members + jobs)
                .toList();
        var estimates = new TreeMap<String, Estimate>();
        for (int member = 0; member < members; member++) {
            estimates.put("m" + member, Estimate.straight(places.get(member), places.subList(members, places.size())));
        }
        return estimates;
    }

    private static double value(
            SortedMap<String, Estimate> estimates, SortedMap<String, List<Integer>> routes, Objective objective) {
        var costs = routes.entrySet().stream()
                .mapToDouble(route -> JobRoutes.cost(estimates.get(route.getKey()), route.getValue()));
        return objective == Objective.SUM ? costs.sum() : costs.max().orElse(0);
    }

    /// Tries each place in each route for each job.
    private static double best(SortedMap<String, Estimate> estimates, int jobs, Objective objective) {
        var routes = new TreeMap<String, List<Integer>>();
        estimates.keySet().forEach(name -> routes.put(name, new ArrayList<>()));
        return best(estimates, routes, 0, jobs, objective);
    }

    private static double best(
            SortedMap<String, Estimate> estimates,
            SortedMap<String, List<Integer>> routes,
            Integer job,
            int jobs,
            Objective objective) {
        if (job == jobs) {
            return value(estimates, routes, objective);
        }
        double best = Double.POSITIVE_INFINITY;
        for (List<Integer> route : routes.values()) {
            for (int position = 0; position <= route.size(); position++) {
                route.add(position, job);
                best = Math.min(best, best(estimates, routes, job + 1, jobs, objective));
                route.remove(/* element */ job);
            }
        }
        return best;
    }

    private static void assertThatEachJobIsDoneOnce(SortedMap<String, List<Integer>> routes, int jobs) {
        var all = new ArrayList<Integer>();
        routes.values().forEach(all::addAll);
        assertThat(all).doesNotHaveDuplicates().hasSize(jobs);
    }

    @ParameterizedTest
    @EnumSource(Objective.class)
    void isTheBestOfAllDivisionsOfAFew(Objective objective) {
        for (int seed = 0; seed < 100; seed++) {
            var random = new SplittableRandom(seed);
            int jobs = random.nextInt(1, 6);
            var estimates = anywhere(random, random.nextInt(1, 4), jobs);
            var routes = JobRoutes.divide(estimates, objective);
            assertThatEachJobIsDoneOnce(routes, jobs);
            double best = best(estimates, jobs, objective);
            assertThat(value(estimates, routes, objective)).as("seed %d", seed).isBetween(best - 1e-9, 1.005 * best);
        }
    }

    @EnabledIfSystemProperty(named = "rsal.test.all", matches = "true", disabledReason = "runs by ./rsal test --all")
    @ParameterizedTest
    @EnumSource(Objective.class)
    void isNearTheBestForMore(Objective objective) {
        double sumOfRatios = 0;
        int runs = 100;
        for (int seed = 0; seed < runs; seed++) {
            var random = new SplittableRandom(seed);
            int jobs = ExactRoutes.MOST_JOBS + random.nextInt(3);
            var estimates = anywhere(random, random.nextInt(1, 5), jobs);
            var routes = JobRoutes.search(estimates, objective);
            assertThatEachJobIsDoneOnce(routes, jobs);
            double best = value(estimates, ExactRoutes.divide(estimates, objective), objective);
            double ratio = value(estimates, routes, objective) / best;
            assertThat(ratio).as("seed %d", seed).isBetween(0.995, 1.10);
            sumOfRatios += ratio;
        }
        assertThat(sumOfRatios / runs).isLessThan(1.02);
    }

    @ParameterizedTest
    @EnumSource(Objective.class)
    void leavesOutWhatNobodyCanDoAndGivesWhatOneCanToThatOne(Objective objective) {
        double no = Double.POSITIVE_INFINITY;
        List<List<Double>> ways = List.of(List.of(0.0, 1.0, no), List.of(1.0, 0.0, no), List.of(no, no, no));
        var estimates = new TreeMap<String, Estimate>();
        estimates.put("amy", new Estimate(true, List.of(1.0, no, no), ways).without(Set.of(1)));
        estimates.put("bob", new Estimate(true, List.of(1.0, 50.0, no), ways));
        var routes = JobRoutes.divide(estimates, objective);
        assertThat(routes.values().stream().flatMap(List::stream)).containsExactlyInAnyOrder(0, 1);
        assertThat(routes.get("bob")).contains(1);
    }
}
