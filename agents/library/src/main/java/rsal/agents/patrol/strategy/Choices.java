package rsal.agents.patrol.strategy;

import java.util.function.IntToDoubleFunction;

/// Choices among places.
final class Choices {
    private static final double AT_PLACE = 2; // m

    private Choices() {}

    /// The place with the largest value; the first of several, and [PatrolView#NONE] when there is none.
    static int best(int[] places, IntToDoubleFunction value) {
        int best = PatrolView.NONE;
        double most = Double.NEGATIVE_INFINITY;
        for (int place : places) {
            double its = value.applyAsDouble(place);
            if (best == PatrolView.NONE || its > most) {
                best = place;
                most = its;
            }
        }
        return best;
    }

    /// Where a robot decides that goes from neighbor to neighbor: its place's neighbors; only the nearest place
    /// while it is at none.
    static int[] around(PatrolView view) {
        int here = view.here();
        int[] neighbors = view.graph().neighbors(here);
        return view.lengthTo(here) > AT_PLACE || neighbors.length == 0 ? new int[] {here} : neighbors;
    }

    /// All places but the one where the robot is.
    static int[] others(PatrolView view) {
        int[] all = PatrolPlan.all(view.graph());
        return all.length == 1 ? all : Tours.without(all, view.here(), 1);
    }

    /// The largest of all path lengths between places that can be reached [m].
    static double longest(PatrolGraph graph) {
        double longest = 0;
        for (int from = 0; from < graph.size(); from++) {
            for (int to = 0; to < graph.size(); to++) {
                double length = graph.length(from, to);
                longest = Double.isFinite(length) ? Math.max(longest, length) : longest;
            }
        }
        return Math.max(longest, 1e-9);
    }
}
