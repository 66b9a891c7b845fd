package rsal.agent.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.SortedMap;
import java.util.TreeMap;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;

class AssignmentTest {
    @Test
    void costsAsLittleAsTheBestOfAllWays() {
        for (long seed = 0; seed < 300; seed++) {
            var random = new Random(seed);
            int rows = 1 + random.nextInt(6);
            var cost = new double[rows][rows + random.nextInt(3)];
            for (double[] row : cost) {
                Arrays.setAll(row, _ -> random.nextInt(4) == 0 ? 5 : 10 * random.nextDouble()); // ties too
            }
            int[] columnOf = Assignment.pair(cost);
            double sum = IntStream.range(0, rows)
                    .mapToDouble(row -> cost[row][columnOf[row]])
                    .sum();
            assertThat(columnOf).as("seed %d", seed).doesNotHaveDuplicates();
            assertThat(sum).as("seed %d", seed).isCloseTo(best(cost, 0, 0), within(1e-9));
        }
    }

    /// Tries each free column for each row.
    private static double best(double[][] cost, int row, int used) {
        double best = row == cost.length ? 0 : Double.POSITIVE_INFINITY;
        for (int column = 0; row < cost.length && column < cost[row].length; column++) {
            if ((used & 1 << column) == 0) {
                best = Math.min(best, cost[row][column] + best(cost, row + 1, used | 1 << column));
            }
        }
        return best;
    }

    @Test
    void placesAreSharedSoThatNobodyGoesMuchFartherThanItMustAndAllTogetherAsLittleAsThatAllows() {
        for (long seed = 0; seed < 300; seed++) {
            var random = new Random(seed);
            int robots = 1 + random.nextInt(5);
            int places = 1 + random.nextInt(5);
            var costs = new TreeMap<String, double[]>();
            for (int robot = 0; robot < robots; robot++) {
                costs.put("r" + robot, random.doubles(places, 0, 10).toArray());
            }
            Map<String, Integer> placeOf = Assignment.even(costs);
            double[] distances = placeOf.entrySet().stream()
                    .mapToDouble(entry -> costs.get(entry.getKey())[entry.getValue()])
                    .toArray();
            assertThat(placeOf.values()).as("seed %d", seed).doesNotHaveDuplicates();
            assertThat(distances).as("seed %d", seed).hasSize(Math.min(robots, places));
            double[][] all = costs.values().toArray(double[][]::new);
            double longest = leastLongest(all, 0, 0, Math.max(0, robots - places));
            assertThat(Arrays.stream(distances).max().orElseThrow()).isLessThanOrEqualTo(1.05 * longest + 1e-9);
            assertThat(Arrays.stream(distances).sum())
                    .as("seed %d", seed)
                    .isCloseTo(leastSum(all, 0, 0, Math.max(0, robots - places), 1.05 * longest), within(1e-9));
        }
    }

    /// @param idle how many rows may be left out
    private static double leastLongest(double[][] cost, int row, int used, int idle) {
        if (row == cost.length) {
            return 0;
        }
        double best = idle > 0 ? leastLongest(cost, row + 1, used, idle - 1) : Double.POSITIVE_INFINITY;
        for (int column = 0; column < cost[row].length; column++) {
            if ((used & 1 << column) == 0) {
                double rest = leastLongest(cost, row + 1, used | 1 << column, idle);
                best = Math.min(best, Math.max(cost[row][column], rest));
            }
        }
        return best;
    }

    private static double leastSum(double[][] cost, int row, int used, int idle, double bound) {
        if (row == cost.length) {
            return 0;
        }
        double best = idle > 0 ? leastSum(cost, row + 1, used, idle - 1, bound) : Double.POSITIVE_INFINITY;
        for (int column = 0; column < cost[row].length; column++) {
            if ((used & 1 << column) == 0 && cost[row][column] <= bound) {
                best = Math.min(best, cost[row][column] + leastSum(cost, row + 1, used | 1 << column, idle, bound));
            }
        }
        return best;
    }

    @Test
    void placesThatCannotBeReachedAreLeftToOthers() {
        double never = Double.POSITIVE_INFINITY;
        var costs = new TreeMap<>(
                Map.of("a", new double[] {1, never}, "b", new double[] {2, never}, "c", new double[] {never, never}));
        assertThat(Assignment.even(costs)).isEqualTo(Map.of("a", 0));
        assertThat(Assignment.even(new TreeMap<>())).isEmpty();
    }

    @Test
    void eachPreyHasOneHunterBeforeAnyHasTwo() {
        var preyOf = Assignment.nearest(
                line("h1", 0, "h2", 1, "h3", 2, "h4", 3), line("p1", 4, "p2", 100, "p3", 200), Map.of());
        assertThat(preyOf).containsOnlyKeys("h1", "h2", "h3", "h4");
        assertThat(preyOf.values()).contains("p1", "p2", "p3").containsOnlyOnce("p2", "p3");
    }

    @Test
    void preyIsLeftAloneWhenHuntersAreFew() {
        assertThat(Assignment.nearest(line("h1", 0), line("p1", 4, "p2", 3), Map.of()))
                .containsExactly(Map.entry("h1", "p2"));
    }

    @Test
    void nobodyIsAssignedWithoutPrey() {
        assertThat(Assignment.nearest(line("h1", 0), line(), Map.of())).isEmpty();
    }

    @Test
    void equalDistancesAreSettledById() {
        assertThat(Assignment.nearest(line("h1", 0, "h2", 0), line("p1", 1, "p2", 1), Map.of()))
                .isEqualTo(Map.of("h1", "p1", "h2", "p2"));
    }

    @Test
    void huntersStayWithTheirPreyUntilAnotherIsClearlyNearer() {
        var before = Map.of("h1", "p1");
        assertThat(Assignment.nearest(line("h1", 0), line("p1", 10, "p2", 8.5), before))
                .containsValue("p1");
        assertThat(Assignment.nearest(line("h1", 0), line("p1", 10, "p2", 7.5), before))
                .containsValue("p2");
    }

    @Test
    void takingOnesPartChangesNothingForTheOthers() {
        for (long seed = 0; seed < 300; seed++) {
            var random = new Random(seed);
            SortedMap<String, Pose2d> hunters = scattered("h", random);
            SortedMap<String, Pose2d> prey = scattered("p", random);
            var chases = new TreeMap<String, String>();
            hunters.keySet()
                    .forEach(h -> chases.put(h, List.copyOf(prey.keySet()).get(random.nextInt(prey.size()))));
            Map<String, String> planned = Assignment.nearest(hunters, prey, chases);
            for (String hunter : new ArrayList<>(hunters.keySet())) {
                chases.put(hunter, planned.get(hunter));
                assertThat(Assignment.nearest(hunters, prey, chases))
                        .as("seed %d", seed)
                        .isEqualTo(planned);
            }
        }
    }

    private static SortedMap<String, Pose2d> scattered(String prefix, Random random) {
        var poses = new TreeMap<String, Pose2d>();
        int count = 1 + random.nextInt(5);
        for (int i = 0; i < count; i++) {
            poses.put(prefix + i, new Pose2d(60 * random.nextDouble(), 15 * random.nextDouble(), 0));
        }
        return poses;
    }

    private static SortedMap<String, Pose2d> line(Object... namesAndPlaces) {
        var poses = new TreeMap<String, Pose2d>();
        for (int i = 0; i < namesAndPlaces.length; i += 2) {
            double x = ((Number) namesAndPlaces[i + 1]).doubleValue();
            poses.put((String) namesAndPlaces[i], new Pose2d(x, 0, 0));
        }
        return poses;
    }
}
