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
    void survivorsShareThePlacesOfTheLostOne() {
        PatrolGraph graph = RandomPlaces.rooms();
        double planned = new TourSearch(graph).best(3).worst();
        VisitGaps gaps = run(strategy("balanced"), graph, 4, 3, new Loss(0, 2000));
        assertThat(gaps.worst(TIME)).isLessThan(3 * planned);
    }

    private static PatrolView view(PatrolGraph graph, int self, String... names) {
        var view = new PatrolView(graph, new SplittableRandom(1));
        view.setTeam(self, List.of(names));
        return view;
    }

    private static void stand(PatrolView view, double now, int place) {
        var lengths = new double[view.graph().size()];
        Arrays.setAll(lengths, to -> view.graph().length(place, to));
        view.set(now, lengths);
        view.report(view.self(), place, PatrolView.NONE, Double.POSITIVE_INFINITY, new int[0]);
    }

    @Test
    void conscientiousReactiveTriesOtherNeighborsWhenItCannotGetToOne() {
        PatrolGraph graph = RandomPlaces.rooms();
        PatrolStrategy strategy = strategy("cr").create(Arguments.defaults(List.of()));
        PatrolView view = view(graph, 0, "a");
        stand(view, 10, 3);
        int first = strategy.next(view);
        stand(view, 20, 3);
        assertThat(strategy.next(view)).isNotEqualTo(first);
    }

    @Test
    void dynamicTasksNeedNoCommonClock() {
        PatrolGraph graph = RandomPlaces.rooms();
        int size = graph.size();
        PatrolStrategy[] strategies = {
            strategy("dtap").create(Arguments.defaults(List.of())),
            strategy("dtap").create(Arguments.defaults(List.of()))
        };
        PatrolView[] views = {view(graph, 0, "a", "b"), view(graph, 1, "a", "b")};
        int[] at = {0, 11};
        var awards = new int[size];
        for (int round = 1; round < 60; round++) {
            int self = round % 2;
            stand(views[self], 5 * round + (self == 0 ? 1000 : 0), at[self]);
            views[self].visit(at[self], views[self].now());
            views[self].report(1 - self, at[1 - self], PatrolView.NONE, 0, strategies[1 - self].note());
            int[] heard = strategies[1 - self].note();
            at[self] = strategies[self].next(views[self]);
            int[] own = strategies[self].note();
            for (int place = 0; place < size; place++) {
                int award = own[1 + size + place];
                assertThat(award).as("round %d", round).isGreaterThanOrEqualTo(awards[place]);
                if (heard.length > 1 && award == heard[1 + size + place]) {
                    assertThat(own[1 + place]).as("round %d", round).isEqualTo(heard[1 + place]);
                }
                awards[place] = award;
            }
        }
        assertThat(Arrays.stream(awards).sum()).isGreaterThan(5);
    }

    @Test
    void dynamicTasksForgetOwnersWhenOthersAreInTheTeam() {
        PatrolGraph graph = RandomPlaces.rooms();
        int size = graph.size();
        PatrolStrategy strategy = strategy("dtap").create(Arguments.defaults(List.of()));
        PatrolView view = view(graph, 0, "a", "b");
        stand(view, 10, 0);
        strategy.next(view);
        int[] before = strategy.note();
        view.setTeam(1, List.of("_", "a"));
        stand(view, 20, 0);
        int[] stale = before.clone();
        Arrays.fill(stale, 1, 1 + size, 1);
        Arrays.fill(stale, 1 + size, stale.length, 1000);
        view.report(0, 3, PatrolView.NONE, 0, stale);
        strategy.next(view);
        int[] after = strategy.note();
        assertThat(after[0]).isNotEqualTo(before[0]);
        assertThat(Arrays.stream(after, 1 + size, after.length).max().orElseThrow())
                .isLessThan(1000);
    }
}
