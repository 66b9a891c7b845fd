package rsal.agents.patrol.strategy;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import rsal.agents.patrol.strategy.PatrolGraph.Edge;

class PatrolGraphTest {
    @Test
    void pathsAreAsShortAsByTryingAllPlacesBetween() {
        for (int seed = 0; seed < 20; seed++) {
            var random = new SplittableRandom(seed);
            int size = 2 + random.nextInt(20);
            PatrolGraph graph = RandomPlaces.graph(random, size, 1, 0);
            var lengths = new double[size][size];
            for (double[] row : lengths) {
                Arrays.fill(row, Double.POSITIVE_INFINITY);
            }
            for (int from = 0; from < size; from++) {
                lengths[from][from] = 0;
                for (int to : graph.neighborsOf(from)) {
                    lengths[from][to] = graph.length(from, to);
                }
            }
            for (int via = 0; via < size; via++) {
                for (int from = 0; from < size; from++) {
                    for (int to = 0; to < size; to++) {
                        lengths[from][to] = Math.min(lengths[from][to], lengths[from][via] + lengths[via][to]);
                    }
                }
            }
            for (int from = 0; from < size; from++) {
                for (int to = 0; to < size; to++) {
                    assertThat(graph.length(from, to)).as("seed %d", seed).isCloseTo(lengths[from][to], within(1e-9));
                }
            }
        }
    }

    @Test
    void placesWithAnotherBetweenThemAreNoNeighbors() {
        var lengths = new double[] {0, 4, 9, 4, 0, 5, 9, 5, 0};
        PatrolGraph graph = PatrolGraph.ofLengths(lengths, 0.5, 3);
        assertThat(graph.neighborsOf(0)).containsExactly(1);
        assertThat(graph.neighborsOf(1)).containsExactly(0, 2);
        assertThat(graph.firstStep(0, 2)).isEqualTo(1);
        assertThat(graph.time(0, 2)).isEqualTo(21);
    }

    @Test
    void pathOverAPlaceThatLiesAlmostBetweenHasTwoEdges() {
        var lengths = new double[] {0, 4, 9, 4, 0, 5.2, 9, 5.2, 0};
        PatrolGraph graph = PatrolGraph.ofLengths(lengths, 0.5, 3);
        assertThat(graph.neighborsOf(0)).containsExactly(1);
        assertThat(graph.firstStep(0, 2)).isEqualTo(1);
        assertThat(graph.hops(0)).containsExactly(0, 1, 2);
    }

    /// Planned paths are never exact sums of others, so that lengths here have noise.
    @Test
    void stepsLeadFromNeighborToNeighborToEachPlace() {
        for (int seed = 0; seed < 20; seed++) {
            var random = new SplittableRandom(seed);
            int size = 2 + random.nextInt(20);
            PatrolGraph exact = RandomPlaces.graph(random, size, 1, 0);
            var lengths = new double[size * size];
            for (int from = 0; from < size; from++) {
                for (int to = 0; to < from; to++) {
                    lengths[from * size + to] = exact.length(from, to) * (1 + 0.01 * random.nextDouble());
                    lengths[to * size + from] = lengths[from * size + to];
                }
            }
            PatrolGraph graph = PatrolGraph.ofLengths(lengths, 1, 0);
            for (int from = 0; from < size; from++) {
                for (int to = 0; to < size; to++) {
                    int steps = 0;
                    for (int here = from; here != to; steps++) {
                        int next = graph.firstStep(here, to);
                        assertThat(graph.neighborsOf(here)).as("seed %d", seed).contains(next);
                        here = next;
                    }
                    assertThat(steps).as("seed %d", seed).isBetween(graph.hops(from)[to], size);
                }
            }
        }
    }

    @Test
    void largestPartHasThePlacesThatCanBeReachedFromEachOther() {
        double no = Double.POSITIVE_INFINITY;
        var lengths = new double[] {
            0, no, no, no, //
            no, 0, 2, no, //
            no, 2, 0, 3, //
            no, no, 3, 0
        };
        PatrolGraph graph = PatrolGraph.ofLengths(lengths, 1, 0);
        assertThat(graph.largestPart()).containsExactly(1, 2, 3);
        PatrolGraph part = graph.only(graph.largestPart());
        assertThat(part.size()).isEqualTo(3);
        assertThat(part.length(0, 1)).isEqualTo(2);
        assertThat(part.length(2, 0)).as("over the one between").isEqualTo(5);
    }

    @Test
    void whatIsNoGraphIsRefused() {
        assertThatThrownBy(() -> PatrolGraph.ofLengths(new double[] {0, 1, 1}, 1, 0))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> PatrolGraph.ofLengths(new double[] {0, Double.NaN, 1, 0}, 1, 0))
                .isInstanceOf(IllegalArgumentException.class);
        assertThatThrownBy(() -> PatrolGraph.ofEdges(2, List.of(new Edge(0, 2, 1)), 1, 0))
                .hasMessageContaining("from place 0 to place 2");
        assertThatThrownBy(() -> PatrolGraph.ofEdges(2, List.of(new Edge(0, 1, 0)), 1, 0))
                .hasMessageContaining("0.0 m");
        assertThatThrownBy(() -> PatrolGraph.ofEdges(2, List.of(), 0, 0)).hasMessageContaining("speed");
    }
}
