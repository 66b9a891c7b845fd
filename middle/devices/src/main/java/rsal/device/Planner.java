package rsal.device;

import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.data.Path2d;
import rsal.data.Pose2d;

/// Finds ways. Asking moves nothing: so costs can be compared and it can be asked whether a place can be reached.
public interface Planner extends Device {
    CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal);

    /// What ways from one place to several cost, in their order: as of those that it would find; +∞ where none leads.
    /// Takes less than to plan them one by one, where that can be.
    ///
    /// @param near how far from its goal a way may end [m], at least 0; +∞ for as far as the planner ever has it
    default CompletionStage<List<Double>> costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals, double near) {
        CompletionStage<List<Double>> costs = CompletableFuture.completedStage(List.of());
        for (Pose2d mapFromGoal : mapFromGoals) {
            costs = costs.thenCombine(plan(mapFromStart, mapFromGoal), (before, result) -> {
                var all = new ArrayList<>(before);
                all.add(
                        result instanceof Result.Found found && found.offGoal() <= near
                                ? found.cost()
                                : Double.POSITIVE_INFINITY);
                return all;
            });
        }
        return costs;
    }

    sealed interface Result {
        /// @param cost length of the way [m], more where it is narrow: what to compare ways by
        /// @param offGoal how far from the goal it ends [m], when the robot can't be there but near it; else 0
        record Found(Path2d path, double cost, double offGoal) implements Result {}

        record NoPath(String why) implements Result {}
    }
}
