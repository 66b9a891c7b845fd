package rsal.agents;

import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Pose2d;
import rsal.device.Planner;

/// What ways cost. A way that ends near a place because the robot does not fit there leads nowhere: it would not be
/// driven either.
final class Ways {
    private final Optional<Planner> planner;

    /// @param planner without one, ways are straight
    Ways(Optional<Planner> planner) {
        this.planner = planner;
    }

    /// Cost of a way from place to place [m, more where it is narrow]; +∞ where none leads.
    ///
    /// @param mapFromPlaces in their order, the start first
    CompletionStage<Double> cost(List<Pose2d> mapFromPlaces) {
        CompletionStage<Double> sum = CompletableFuture.completedStage(0.0);
        for (int i = 1; i < mapFromPlaces.size(); i++) {
            sum = sum.thenCombine(cost(mapFromPlaces.get(i - 1), mapFromPlaces.get(i)), Double::sum);
        }
        return sum;
    }

    CompletionStage<Double> cost(Pose2d mapFromStart, Pose2d mapFromGoal) {
        if (planner.isEmpty()) {
            return CompletableFuture.completedStage(mapFromStart.distanceTo(mapFromGoal));
        }
        return planner.get().plan(mapFromStart, mapFromGoal).handle((result, _) -> switch (result) {
            case Planner.Result.Found found when found.offGoal() == 0 -> found.cost();
            case null, default -> Double.POSITIVE_INFINITY;
        });
    }
}
