package rsal.agents.patrol.strategy;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import rsal.agents.patrol.strategy.PatrolGraph.Edge;

/// Graphs for tests.
final class RandomPlaces {
    private RandomPlaces() {}

    /// A tree with some more edges.
    static PatrolGraph graph(SplittableRandom random, int size, double speed, double stop) {
        List<Edge> edges = new ArrayList<>();
        for (int place = 1; place < size; place++) {
            edges.add(new Edge(random.nextInt(place), place, 1 + 20 * random.nextDouble()));
        }
        for (int i = 0; i < size / 3; i++) {
            int from = random.nextInt(size);
            int to = random.nextInt(size);
            if (from != to) {
                edges.add(new Edge(from, to, 1 + 20 * random.nextDouble()));
            }
        }
        return PatrolGraph.ofEdges(size, edges, speed, stop);
    }

    /// Two rooms of four places, 2 m apart, on a corridor of 30 m with four more places.
    static PatrolGraph rooms() {
        List<Edge> edges = new ArrayList<>();
        for (int place = 0; place < 3; place++) {
            edges.add(new Edge(place, place + 1, 2));
            edges.add(new Edge(4 + place, 5 + place, 10));
            edges.add(new Edge(8 + place, 9 + place, 2));
        }
        edges.add(new Edge(0, 3, 2));
        edges.add(new Edge(8, 11, 2));
        edges.add(new Edge(3, 4, 3));
        edges.add(new Edge(7, 8, 3));
        return PatrolGraph.ofEdges(12, edges, 1, 0);
    }
}
