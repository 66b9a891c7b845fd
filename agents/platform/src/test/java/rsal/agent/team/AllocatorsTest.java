package rsal.agent.team;

import static org.assertj.core.api.Assertions.assertThat;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Set;
import java.util.SplittableRandom;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.agent.team.Allocator.Said;
import rsal.data.Point2d;
import rsal.settings.Arguments;

/// Auctions among a few members compared with the exact optimum, over networks that lose messages.
class AllocatorsTest {
    private static final int INSTANCES = Boolean.getBoolean("rsal.test.all") ? 1000 : 100;
    private static final double DISCOUNT = 0.97;

    /// Members and jobs anywhere in a square of 40 m.
    private static NavigableMap<String, Estimate> anywhere(SplittableRandom random, int members, int jobs) {
        List<Point2d> places = Stream.generate(() -> new Point2d(random.nextDouble(40), random.nextDouble(40)))
                .limit(members + jobs)
                .toList();
        var estimates = new TreeMap<String, Estimate>();
        for (int member = 0; member < members; member++) {
            estimates.put("m" + member, Estimate.straight(places.get(member), places.subList(members, places.size())));
        }
        return estimates;
    }

    private static AllocationType type(String key) {
        return key.equals("ssi") ? new SequentialAuctions() : new ConsensusBundles();
    }

    private static Arguments arguments(AllocationType type, String bid) {
        return Arguments.of(
                type.parameters(),
                type.key().equals("cbba") ? Map.of("bid", bid, "discount", DISCOUNT) : Map.of("bid", bid));
    }

    /// A run of one auction: in each round each member may hear each other, by chance.
    private static final class Auction {
        private final Map<String, Allocator> members = new LinkedHashMap<>();
        private int rounds;

        Auction(String key, String bid, NavigableMap<String, Estimate> estimates) {
            AllocationType type = type(key);
            List<String> names = List.copyOf(estimates.keySet());
            estimates.forEach((name, estimate) -> members.put(
                    name,
                    type.create(arguments(type, bid), new AllocationType.Auction(name, names, estimate))
                            .orElseThrow()));
        }

        /// @param lost share of messages that get lost
        /// @param neighbors whether a member hears only the two next to it in a ring
        void run(SplittableRandom random, double lost, boolean neighbors, int most) {
            List<String> names = List.copyOf(members.keySet());
            var late = new ArrayList<Map.Entry<String, Said>>();
            while (rounds < most && !members.values().stream().allMatch(Allocator::isSettled)) {
                rounds++;
                var sent = new ArrayList<Map.Entry<String, Said>>(late);
                late.clear();
                members.forEach((name, member) -> sent.add(Map.entry(name, member.said())));
                for (Map.Entry<String, Said> message : sent) {
                    for (String name : names) {
                        int apart = Math.abs(names.indexOf(name) - names.indexOf(message.getKey()));
                        boolean near = !neighbors || apart == 1 || apart == names.size() - 1;
                        if (!name.equals(message.getKey()) && near && random.nextDouble() >= lost) {
                            members.get(name).hear(message.getKey(), message.getValue());
                        }
                    }
                    if (lost > 0 && random.nextInt(5) == 0) {
                        late.add(message); // comes once more, after newer ones
                    }
                }
            }
        }

        NavigableMap<String, List<Integer>> routes() {
            var routes = new TreeMap<String, List<Integer>>();
            members.forEach((name, member) -> routes.put(name, member.route()));
            return routes;
        }

        void assertThatEachJobIsWonOnce(int jobs, String as) {
            var all = new ArrayList<Integer>();
            routes().values().forEach(all::addAll);
            assertThat(all).as(as).doesNotHaveDuplicates().hasSize(jobs);
        }
    }

    private static double cost(
            NavigableMap<String, Estimate> estimates, Map<String, List<Integer>> routes, Objective objective) {
        var costs = routes.entrySet().stream()
                .mapToDouble(route -> JobRoutes.cost(estimates.get(route.getKey()), route.getValue()));
        return objective == Objective.SUM ? costs.sum() : costs.max().orElse(0);
    }

    private static double value(NavigableMap<String, Estimate> estimates, Map<String, List<Integer>> routes) {
        return routes.entrySet().stream()
                .mapToDouble(
                        route -> -BidRule.DISCOUNTED.value(estimates.get(route.getKey()), route.getValue(), DISCOUNT))
                .sum();
    }

    /// The most that all jobs can be worth: each next job of each member is tried, for all sets of jobs.
    private static double mostValue(NavigableMap<String, Estimate> estimates, int jobs) {
        int sets = 1 << jobs;
        var best = new double[sets]; // of jobs that are left to the members seen so far
        for (Estimate estimate : estimates.values()) {
            var from = new double[sets][jobs]; // what a set is worth at the end of a job that is not in it
            for (int set = 0; set < sets; set++) {
                for (int at = 0; at < jobs; at++) {
                    for (int next = 0; next < jobs; next++) {
                        if ((set & 1 << next) != 0) {
                            double path = estimate.after().get(at).get(next);
                            double worth = Math.pow(DISCOUNT, path) * (1 + from[set & ~(1 << next)][next]);
                            from[set][at] = Math.max(from[set][at], worth);
                        }
                    }
                }
            }
            var own = new double[sets];
            for (int set = 0; set < sets; set++) {
                for (int next = 0; next < jobs; next++) {
                    if ((set & 1 << next) != 0) {
                        double worth =
                                Math.pow(DISCOUNT, estimate.first().get(next)) * (1 + from[set & ~(1 << next)][next]);
                        own[set] = Math.max(own[set], worth);
                    }
                }
            }
            var with = new double[sets];
            for (int set = 0; set < sets; set++) {
                for (int mine = set; ; mine = (mine - 1) & set) {
                    with[set] = Math.max(with[set], own[mine] + best[set & ~mine]);
                    if (mine == 0) {
                        break;
                    }
                }
            }
            best = with;
        }
        return best[sets - 1];
    }

    @ParameterizedTest
    @CsvSource({
        "ssi, minisum, 2.0, 1.05", // Lagoudakis et al. 2005
        "ssi, minimax, 6.0, 1.2", // the same: twice the number of members
        "cbba, minisum, 2.0, 1.05", // as auctions, where no bid is outdone by a later one
        "cbba, minimax, 6.0, 1.2",
        "cbba, discounted, 2.0, 1.05" // Choi, Brunet and How 2009: at least half of the value
    })
    void isWithinItsBoundOfTheBestOfAFewJobs(String key, String bid, double bound, double mean) {
        double sum = 0;
        double worst = 0;
        int rounds = 0;
        for (int seed = 0; seed < INSTANCES; seed++) {
            var random = new SplittableRandom(seed);
            int jobs = random.nextInt(1, 9);
            var estimates = anywhere(random, 3, jobs);
            var auction = new Auction(key, bid, estimates);
            auction.run(random, 0, false, 200);
            auction.assertThatEachJobIsWonOnce(jobs, "seed " + seed);
            double ratio;
            if (bid.equals("discounted")) {
                ratio = mostValue(estimates, jobs) / value(estimates, auction.routes());
            } else {
                Objective objective = bid.equals("minisum") ? Objective.SUM : Objective.LONGEST;
                double best = cost(estimates, ExactRoutes.divide(estimates, objective), objective);
                ratio = cost(estimates, auction.routes(), objective) / best;
            }
            assertThat(ratio).as("seed %d", seed).isBetween(0.995, bound);
            sum += ratio;
            worst = Math.max(worst, ratio);
            rounds += auction.rounds;
        }
        String means = "mean ratio %.3f, worst %.2f, mean rounds %.1f"
                .formatted(sum / INSTANCES, worst, (double) rounds / INSTANCES);
        if (Boolean.getBoolean("rsal.test.all")) {
            System.out.println(key + " " + bid + ": " + means);
        }
        assertThat(sum / INSTANCES).as(means).isLessThan(mean);
    }

    @ParameterizedTest
    @CsvSource({"ssi, minisum", "ssi, minimax", "cbba, minisum", "cbba, minimax", "cbba, discounted"})
    void lostAndLateMessagesOnlyDelayIt(String key, String bid) {
        for (int seed = 0; seed < INSTANCES / 2; seed++) {
            var random = new SplittableRandom(seed);
            int jobs = random.nextInt(1, 13);
            var estimates = anywhere(random, random.nextInt(1, 7), jobs);
            var auction = new Auction(key, bid, estimates);
            auction.run(random, 0.4, false, 500);
            String as = "%s %s, seed %d, %d members, %d jobs".formatted(key, bid, seed, estimates.size(), jobs);
            assertThat(auction.members.values()).as(as).allMatch(Allocator::isSettled);
            auction.assertThatEachJobIsWonOnce(jobs, as);
        }
    }

    /// Lost messages change nothing in the result of sequential auctions.
    @Test
    void sequentialAuctionsHaveTheSameResultWhateverIsLost() {
        for (int seed = 0; seed < 50; seed++) {
            var estimates = anywhere(new SplittableRandom(seed), 4, 9);
            var whole = new Auction("ssi", "minimax", estimates);
            whole.run(new SplittableRandom(seed), 0, false, 500);
            var torn = new Auction("ssi", "minimax", estimates);
            torn.run(new SplittableRandom(seed), 0.5, false, 500);
            assertThat(torn.routes()).isEqualTo(whole.routes());
        }
    }

    /// Consensus needs no member that hears all others.
    @ParameterizedTest
    @CsvSource({"minisum", "minimax", "discounted"})
    void neighborsAreEnoughForConsensus(String bid) {
        for (int seed = 0; seed < INSTANCES / 3; seed++) {
            var random = new SplittableRandom(seed);
            int jobs = random.nextInt(1, 11);
            var auction = new Auction("cbba", bid, anywhere(random, 6, jobs));
            auction.run(random, 0.2, true, 60);
            auction.assertThatEachJobIsWonOnce(jobs, "seed " + seed);
        }
    }

    @ParameterizedTest
    @CsvSource({"ssi, minimax", "cbba, minimax"})
    void jobsOfOneThatLeavesGoToOthersAndWhatNobodyCanDoIsLeft(String key, String bid) {
        double no = Double.POSITIVE_INFINITY;
        var ways = List.of(List.of(0.0, 5.0, no), List.of(5.0, 0.0, no), List.of(no, no, no));
        var estimates = new TreeMap<String, Estimate>();
        estimates.put("amy", new Estimate(true, List.of(3.0, no, no), ways).without(Set.of(1)));
        estimates.put("bob", new Estimate(true, List.of(4.0, 9.0, no), ways));
        estimates.put("eve", new Estimate(true, List.of(1.0, 1.0, no), ways));
        var auction = new Auction(key, bid, estimates);
        auction.members.remove("eve");
        auction.members.values().forEach(member -> member.leave("eve"));
        auction.run(new SplittableRandom(1), 0, false, 100);
        assertThat(auction.members.values()).allMatch(Allocator::isSettled);
        assertThat(auction.routes().get("bob")).contains(1);
        auction.assertThatEachJobIsWonOnce(2, key);
    }
}
