package rsal.navigation.explore;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/// Who goes to which frontier: again and again the pair of robot and frontier that pays most, after which all
/// that may be seen from there pays less. W. Burgard et al., Coordinated Multi-Robot Exploration, IEEE
/// Transactions on Robotics 21 (2005), algorithm 1, with frontiers in place of cells.
public final class FrontierAssignment {
    private static final double WORTH = 0.5; // meters of way that a meter of frontier is worth
    private static final double MOST_WORTH = 3; // m

    private FrontierAssignment() {}

    /// @param frontiers that are known
    /// @param costs by robot and frontier: meters of way, +∞ where there is none
    /// @param view how far robots see in meters
    /// @return by robot the number of its frontier; empty for those for whom none is left
    public static List<Optional<Integer>> assign(List<Frontier> frontiers, double[][] costs, double view) {
        var worth = new double[frontiers.size()];
        Arrays.setAll(worth, i -> Math.min(MOST_WORTH, WORTH * frontiers.get(i).length()));
        List<Optional<Integer>> chosen = new ArrayList<>();
        for (int robot = 0; robot < costs.length; robot++) {
            chosen.add(Optional.empty());
        }
        for (int round = 0; round < costs.length; round++) {
            int bestRobot = -1;
            int best = -1;
            double most = Double.NEGATIVE_INFINITY;
            for (int robot = 0; robot < costs.length; robot++) {
                for (int i = 0; i < worth.length; i++) {
                    double pay = worth[i] - costs[robot][i];
                    if (chosen.get(robot).isEmpty() && pay > most) {
                        most = pay;
                        bestRobot = robot;
                        best = i;
                    }
                }
            }
            if (bestRobot < 0) {
                return chosen;
            }
            chosen.set(bestRobot, Optional.of(best));
            for (int i = 0; i < worth.length; i++) {
                double distance =
                        frontiers.get(i).place().distanceTo(frontiers.get(best).place());
                worth[i] -= i == best
                        ? Double.POSITIVE_INFINITY // one is enough there
                        : MOST_WORTH * Math.max(0, 1 - distance / (2 * view));
            }
        }
        return chosen;
    }
}
