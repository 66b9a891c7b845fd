package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.function.ToDoubleFunction;
import org.jspecify.annotations.Nullable;

/// Divides places into tours so that the longest time between two visits is short, and the mean, too. A pure
/// function of the places' path lengths and the number of robots, so that all members of a team find the same
/// plan without a word.
///
/// A tour over all places is cut into pieces at about 20 offsets, as long as a bound that is bisected allows
/// (G. Frederickson et al., "Approximation algorithms for some routing problems", 1978, for the splitting of a
/// tour). The best ones are improved: a place moves to another tour, or two places of different tours are
/// exchanged, as long as the plan gets better.
final class TourSearch {
    /// Of the mean time between visits, against the longest.
    private static final double WEIGHT_OF_MEAN = 0.5;

    /// Share of the time between two visits that robots keep apart on a shared tour.
    static final double SPACING = 0.95;

    private static final double UNEVEN = 1.1; // robots that share a tour do not stay evenly spaced
    private static final int OFFSETS = 20;
    private static final int IMPROVED = 4; // cuts, of each number of tours
    private static final int BISECTIONS = 14;
    private static final int MOST_FOR_EXCHANGES = 120; // places
    private static final double GAIN = 1e-6; // s

    private final PatrolGraph graph;

    TourSearch(PatrolGraph graph) {
        this.graph = graph;
    }

    /// The best plan with any number of tours: from one that all robots share to one for each robot.
    PatrolPlan best(int members) {
        int[] all = Tours.over(graph, PatrolPlan.all(graph));
        PatrolPlan best = PatrolPlan.cycle(graph, members, all);
        for (int tours = 2; tours <= Math.min(members, graph.size()); tours++) {
            PatrolPlan plan = divided(all, tours, members, TourSearch::score);
            best = score(plan) < score(best) - GAIN ? plan : best;
        }
        return best;
    }

    /// The plan with a tour for each robot whose longest tour is shortest.
    PatrolPlan partition(int members) {
        int tours = Math.min(members, graph.size());
        return tours == 1
                ? PatrolPlan.cycle(graph, members)
                : divided(
                        Tours.over(graph, PatrolPlan.all(graph)),
                        tours,
                        members,
                        plan -> plan.worst() + 1e-3 * plan.meanGap());
    }

    /// What a plan costs [s].
    static double score(PatrolPlan plan) {
        double worst = 0;
        double mean = 0;
        int places = 0;
        for (int tour = 0; tour < plan.size(); tour++) {
            double gap = plan.gap(tour) * (plan.robots(tour) > 1 ? UNEVEN : 1);
            worst = Math.max(worst, gap);
            mean += gap * plan.places(tour).length;
            places += plan.places(tour).length;
        }
        return worst + WEIGHT_OF_MEAN * mean / places;
    }

    /// @param all a short tour over all places
    private PatrolPlan divided(int[] all, int tours, int members, ToDoubleFunction<PatrolPlan> cost) {
        int[] robots = PatrolPlan.shares(tours, members);
        var plans = new ArrayList<PatrolPlan>();
        plans.add(new PatrolPlan(graph, cellTours(tours), robots));
        int step = Math.max(1, all.length / OFFSETS);
        for (int offset = 0; offset < all.length; offset += step) {
            plans.add(new PatrolPlan(graph, cut(all, offset, robots), robots));
        }
        plans.sort(Comparator.comparingDouble(cost));
        PatrolPlan best = plans.getFirst();
        for (PatrolPlan plan : plans.subList(0, Math.min(IMPROVED, plans.size()))) {
            PatrolPlan better = improved(plan, cost);
            best = cost.applyAsDouble(better) < cost.applyAsDouble(best) - GAIN ? better : best;
        }
        return best;
    }

    private List<int[]> cellTours(int tours) {
        PatrolPlan cells = PatrolPlan.voronoi(graph, tours);
        var all = new ArrayList<int[]>();
        for (int tour = 0; tour < tours; tour++) {
            all.add(cells.tour(tour));
        }
        return all;
    }

    /// Pieces of a tour in their order, each within its robots' share of the least bound with which all places
    /// get one.
    private List<int[]> cut(int[] tour, int offset, int[] robots) {
        double low = 0;
        double high = Tours.time(graph, tour);
        List<int[]> best = pieces(tour, offset, robots, Double.POSITIVE_INFINITY);
        for (int i = 0; i < BISECTIONS; i++) {
            double bound = (low + high) / 2;
            List<int[]> pieces = pieces(tour, offset, robots, bound);
            if (pieces.isEmpty()) {
                low = bound;
            } else {
                best = pieces;
                high = bound;
            }
        }
        return best.stream().map(piece -> Tours.over(graph, piece)).toList();
    }

    /// None when the bound is too small. Leaves at least one place for each piece that follows.
    private List<int[]> pieces(int[] tour, int offset, int[] robots, double bound) {
        var pieces = new ArrayList<int[]>();
        int done = 0;
        for (int piece = 0; piece < robots.length; piece++) {
            int most = tour.length - done - (robots.length - piece - 1);
            int count = 1;
            int first = tour[(offset + done) % tour.length];
            double time = graph.stop();
            int last = first;
            while (count < most) {
                int next = tour[(offset + done + count) % tour.length];
                double longer = time + graph.time(last, next);
                if (longer + graph.length(next, first) / graph.speed() > bound * robots[piece]) {
                    break;
                }
                time = longer;
                last = next;
                count++;
            }
            var places = new int[count];
            for (int i = 0; i < count; i++) {
                places[i] = tour[(offset + done + i) % tour.length];
            }
            pieces.add(places);
            done += count;
        }
        return done == tour.length ? pieces : List.of();
    }

    private PatrolPlan improved(PatrolPlan plan, ToDoubleFunction<PatrolPlan> cost) {
        PatrolPlan best = plan;
        @Nullable PatrolPlan better = plan;
        while (better != null) {
            best = better;
            better = moved(best, cost);
            if (better == null && graph.size() <= MOST_FOR_EXCHANGES) {
                better = exchanged(best, cost);
            }
        }
        return best;
    }

    /// With one place in another tour; null when that does not help.
    private @Nullable PatrolPlan moved(PatrolPlan plan, ToDoubleFunction<PatrolPlan> cost) {
        double least = cost.applyAsDouble(plan) - GAIN;
        PatrolPlan best = null;
        for (int from = 0; from < plan.size(); from++) {
            int[] places = plan.places(from);
            for (int i = 0; i < places.length && places.length > 1; i++) {
                int[] rest = Tours.without(places, i, 1);
                for (int to = 0; to < plan.size(); to++) {
                    if (to != from) {
                        int[] target = plan.places(to);
                        int[] longer = Tours.with(target, Tours.slot(graph, target, places[i]), places[i]);
                        PatrolPlan other = plan.with(from, rest, to, longer);
                        if (cost.applyAsDouble(other) < least) {
                            least = cost.applyAsDouble(other);
                            best = other;
                        }
                    }
                }
            }
        }
        return best == null ? null : shortened(best);
    }

    /// With two places exchanged; null when that does not help.
    private @Nullable PatrolPlan exchanged(PatrolPlan plan, ToDoubleFunction<PatrolPlan> cost) {
        double least = cost.applyAsDouble(plan) - GAIN;
        for (int from = 0; from < plan.size(); from++) {
            for (int to = from + 1; to < plan.size(); to++) {
                int[] first = plan.places(from);
                int[] second = plan.places(to);
                for (int i = 0; i < first.length; i++) {
                    for (int j = 0; j < second.length; j++) {
                        PatrolPlan other = plan.with(
                                from,
                                put(Tours.without(first, i, 1), second[j]),
                                to,
                                put(Tours.without(second, j, 1), first[i]));
                        if (cost.applyAsDouble(other) < least) {
                            return shortened(other);
                        }
                    }
                }
            }
        }
        return null;
    }

    private int[] put(int[] tour, int place) {
        return Tours.with(tour, Tours.slot(graph, tour, place), place);
    }

    private PatrolPlan shortened(PatrolPlan plan) {
        var tours = new ArrayList<int[]>();
        var robots = new int[plan.size()];
        for (int tour = 0; tour < plan.size(); tour++) {
            int[] places = plan.tour(tour);
            Tours.improve(graph, places);
            tours.add(places);
            robots[tour] = plan.robots(tour);
        }
        return new PatrolPlan(graph, tours, robots);
    }
}
