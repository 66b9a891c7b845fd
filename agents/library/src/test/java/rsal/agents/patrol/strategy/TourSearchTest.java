package rsal.agents.patrol.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class TourSearchTest {
    /// Time of the shortest tour over each set of places: M. Held and R. Karp, "A dynamic programming approach to
    /// sequencing problems" (1962).
    private static double[] shortest(PatrolGraph graph) {
        int size = graph.size();
        var best = new double[1 << size];
        Arrays.fill(best, Double.POSITIVE_INFINITY);
        for (int start = 0; start < size; start++) {
            var paths = new double[1 << size][size]; // from the start, over all of a set, to each place
            for (double[] row : paths) {
                Arrays.fill(row, Double.POSITIVE_INFINITY);
            }
            paths[1 << start][start] = 0;
            for (int set = 0; set < 1 << size; set++) {
                for (int last = 0; last < size; last++) {
                    if (Double.isFinite(paths[set][last])) {
                        best[set] = Math.min(best[set], paths[set][last] + graph.time(last, start));
                        for (int next = start + 1; next < size; next++) { // the start is the least of them
                            if ((set >> next & 1) == 0) {
                                double time = paths[set][last] + graph.time(last, next);
                                paths[set | 1 << next][next] = Math.min(paths[set | 1 << next][next], time);
                            }
                        }
                    }
                }
            }
        }
        return best;
    }

    /// The least longest tour of all partitions into as many sets.
    private static double exact(double[] shortest, int set, int sets) {
        if (sets == 1) {
            return shortest[set];
        }
        double best = Double.POSITIVE_INFINITY;
        for (int part = (set - 1) & set; part > 0; part = (part - 1) & set) {
            if (shortest[part] < best) {
                best = Math.min(best, Math.max(shortest[part], exact(shortest, set & ~part, sets - 1)));
            }
        }
        return best;
    }

    @Test
    void longestTourIsAlmostAsShortAsThatOfAllPartitions() {
        double sum = 0;
        int graphs = 12;
        for (int seed = 0; seed < graphs; seed++) {
            var random = new SplittableRandom(seed);
            int size = 5 + random.nextInt(4);
            PatrolGraph graph = RandomPlaces.graph(random, size, 0.6, 7);
            int members = 2 + random.nextInt(2);
            double exact = exact(shortest(graph), (1 << size) - 1, members);
            double found = new TourSearch(graph).partition(members).worst();
            assertThat(found).as("seed %d", seed).isBetween(exact - 1e-6, 1.25 * exact);
            sum += found / exact;
        }
        assertThat(sum / graphs).isLessThan(1.03);
    }

    @Test
    void eachPlanHasEachPlaceOnceAndAsManyRobotsAsThereAre() {
        for (int seed = 0; seed < 30; seed++) {
            var random = new SplittableRandom(seed);
            int size = 1 + random.nextInt(30);
            int members = 1 + random.nextInt(9);
            PatrolGraph graph = RandomPlaces.graph(random, size, 1, 2);
            var search = new TourSearch(graph);
            for (PatrolPlan plan : List.of(
                    search.best(members),
                    search.partition(members),
                    PatrolPlan.cycle(graph, members),
                    PatrolPlan.voronoi(graph, members))) {
                var places = new ArrayList<Integer>();
                int robots = 0;
                for (int tour = 0; tour < plan.size(); tour++) {
                    Arrays.stream(plan.tour(tour)).forEach(places::add);
                    robots += plan.robots(tour);
                }
                assertThat(places).as("seed %d", seed).hasSize(size).doesNotHaveDuplicates();
                assertThat(robots).as("seed %d", seed).isEqualTo(members);
                assertThat(plan.slots()).hasSize(members);
            }
        }
    }

    @Test
    void bestPlanCostsNoMoreThanTheCycleAndTheCellsAndIsTheSameForAll() {
        for (int seed = 0; seed < 15; seed++) {
            PatrolGraph graph = RandomPlaces.graph(new SplittableRandom(seed), 18, 1, 0);
            PatrolPlan best = new TourSearch(graph).best(4);
            PatrolPlan again = new TourSearch(graph).best(4);
            double cycle = TourSearch.score(PatrolPlan.cycle(graph, 4));
            double cells = TourSearch.score(PatrolPlan.voronoi(graph, 4));
            assertThat(TourSearch.score(best)).as("seed %d", seed).isLessThanOrEqualTo(Math.min(cycle, cells) + 1e-6);
            for (int tour = 0; tour < best.size(); tour++) {
                assertThat(again.tour(tour)).containsExactly(best.tour(tour));
            }
        }
    }

    @Test
    void placesAtOneSpotHaveCellsOfTheirOwn() {
        PatrolGraph graph = PatrolGraph.ofLengths(new double[] {0, 0, 5, 0, 0, 5, 5, 5, 0}, 1, 0);
        for (int members = 1; members <= 3; members++) {
            PatrolPlan plan = PatrolPlan.voronoi(graph, members);
            assertThat(plan.size()).isEqualTo(members);
            for (int tour = 0; tour < plan.size(); tour++) {
                assertThat(plan.tour(tour)).isNotEmpty();
            }
        }
    }

    @Test
    void planWithTwoOtherToursTakesTheirTimes() {
        PatrolGraph graph = RandomPlaces.graph(new SplittableRandom(1), 9, 0.6, 7);
        PatrolPlan plan = new TourSearch(graph).partition(3);
        int[] first = Tours.with(plan.tour(0), 1, plan.tour(1)[0]);
        int[] second = Tours.without(plan.tour(1), 0, 1);
        PatrolPlan changed = plan.with(0, first, 1, second);
        assertThat(changed.gap(0)).isCloseTo(Tours.time(graph, first), within(1e-9));
        assertThat(changed.gap(1)).isCloseTo(Tours.time(graph, second), within(1e-9));
        assertThat(changed.gap(2)).isEqualTo(plan.gap(2));
    }

    @Test
    void robotsOnOneTourBeginEvenlySpaced() {
        var lengths = new double[64];
        for (int from = 0; from < 8; from++) {
            for (int to = 0; to < 8; to++) {
                int apart = Math.abs(from - to);
                lengths[from * 8 + to] = 5 * Math.min(apart, 8 - apart);
            }
        }
        PatrolPlan ring = PatrolPlan.cycle(PatrolGraph.ofLengths(lengths, 0.5, 0), 4);
        assertThat(ring.worst()).isCloseTo(20, within(1e-9));
        assertThat(ring.slots()).extracting(slot -> slot[1]).containsExactly(0, 2, 4, 6);
    }
}
