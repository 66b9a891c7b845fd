package rsal.agents.patrol.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import rsal.agents.patrol.strategy.IdealPatrol.Loss;
import rsal.settings.Arguments;

/// What each strategy owes, in the ideal model.
class StrategiesTest {
    private static final double TIME = 6000; // s
    private static final double WARM_UP = 1000; // s

    static Stream<PatrolStrategyType> all() {
        return ServiceLoader.load(PatrolStrategyType.class).stream().map(ServiceLoader.Provider::get);
    }

    private static PatrolStrategyType strategy(String key) {
        return all().filter(type -> type.key().equals(key)).findFirst().orElseThrow();
    }

    private static VisitGaps run(PatrolStrategyType type, PatrolGraph graph, int members, long seed, Loss... losses) {
        int[] starts = new SplittableRandom(seed).ints(members, 0, graph.size()).toArray();
        return IdealPatrol.run(
                graph,
                () -> type.create(Arguments.defaults(type.parameters())),
                starts,
                List.of(losses),
                seed,
                WARM_UP,
                TIME);
    }

    @ParameterizedTest
    @MethodSource("all")
    void leavesNoPlaceUnvisitedForEverAndRepeatsItself(PatrolStrategyType type) {
        PatrolGraph graph = RandomPlaces.rooms();
        for (int members = 1; members <= 5; members++) {
            VisitGaps gaps = run(type, graph, members, 7);
            VisitGaps again = run(type, graph, members, 7);
            assertThat(gaps.worst(TIME)).as("%s, %d", type.key(), members).isLessThan(3000);
            assertThat(again.meanGap(TIME)).isEqualTo(gaps.meanGap(TIME));
            assertThat(again.worst(TIME)).isEqualTo(gaps.worst(TIME));
        }
    }

    @ParameterizedTest
    @MethodSource("all")
    void goesOnWhenARobotIsLost(PatrolStrategyType type) {
        VisitGaps gaps = run(type, RandomPlaces.rooms(), 3, 7, new Loss(1, 2000));
        assertThat(gaps.worst(TIME)).isLessThan(3000);
        assertThat(gaps.visits()).isGreaterThan(100);
    }

    @ParameterizedTest
    @MethodSource("all")
    void copesWithOnePlaceAndWithMoreRobotsThanPlaces(PatrolStrategyType type) {
        var one = PatrolGraph.ofLengths(new double[] {0}, 1, 0);
        assertThat(run(type, one, 1, 1).worst(TIME)).isLessThan(5);
        var two = PatrolGraph.ofLengths(new double[] {0, 3, 3, 0}, 1, 0);
        assertThat(run(type, two, 4, 1).worst(TIME)).isLessThan(400);
    }

    @Test
    void balancedHasTheShortestLongestTimeAndMeanOnManyGraphs() {
        double[] worst = new double[4];
        double[] mean = new double[4];
        List<String> keys = List.of("balanced", "sebs", "er", "random");
        for (int seed = 0; seed < 8; seed++) {
            PatrolGraph graph = RandomPlaces.graph(new SplittableRandom(seed), 20, 0.6, 7);
            for (int i = 0; i < worst.length; i++) {
                VisitGaps gaps = run(strategy(keys.get(i)), graph, 4, seed);
                worst[i] += gaps.worst(TIME);
                mean[i] += gaps.meanIdleness(TIME);
            }
        }
        for (int other = 1; other < worst.length; other++) {
            assertThat(worst[0]).as(keys.get(other)).isLessThan(worst[other]);
            assertThat(mean[0]).as(keys.get(other)).isLessThan(mean[other]);
        }
    }

    @Test
    void oneRobotOnARingVisitsEachPlaceOnceARound() {
        var lengths = new double[36];
        Arrays.setAll(lengths, i -> {
            int apart = Math.abs(i / 6 - i % 6);
            return 4.0 * Math.min(apart, 6 - apart);
        });
        VisitGaps gaps = run(strategy("cycle"), PatrolGraph.ofLengths(lengths, 0.5, 2), 1, 1);
        assertThat(gaps.meanGap(TIME)).isCloseTo(6 * (4 / 0.5 + 2), within(1.0));
        assertThat(gaps.meanIdleness(TIME)).isCloseTo(30, within(0.5));
        assertThat(gaps.deviation(TIME)).isLessThan(1);
    }

    @Test
    void survivorsOfAPartitionShareThePlacesOfTheLostOne() {
        PatrolGraph graph = RandomPlaces.rooms();
        double planned = new TourSearch(graph).best(3).worst();
        VisitGaps gaps = run(strategy("balanced"), graph, 4, 3, new Loss(0, 2000));
        assertThat(gaps.worst(TIME)).isLessThan(3 * planned);
    }
}
