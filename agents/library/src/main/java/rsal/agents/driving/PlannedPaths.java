package rsal.agents.driving;

import java.util.Collections;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import rsal.agent.team.PathCostEstimator;
import rsal.data.Pose2d;
import rsal.device.Planner;

/// What ways cost by a robot's planner. A way that ends farther from a place than that, because the robot does not fit
/// there, leads nowhere: it would not be driven either.
public final class PlannedPaths implements PathCostEstimator {
    private final Optional<Planner> planner;
    private final double near;

    /// Ways that lead to the place itself.
    ///
    /// @param planner without one, ways are straight
    public PlannedPaths(Optional<Planner> planner) {
        this(planner, 0);
    }

    /// @param near how far from a place a way may end [m]
    public PlannedPaths(Optional<Planner> planner, double near) {
        this.planner = planner;
        this.near = near;
    }

    @Override
    public CompletionStage<Double> cost(Pose2d mapFromStart, Pose2d mapFromGoal) {
        if (planner.isEmpty()) {
            return CompletableFuture.completedStage(mapFromStart.distanceTo(mapFromGoal));
        }
        return planner.get().plan(mapFromStart, mapFromGoal).handle((result, _) -> switch (result) {
            case Planner.Result.Found found when found.offGoal() <= near -> found.cost();
            case null, default -> Double.POSITIVE_INFINITY;
        });
    }

    /// What ways from one place to several cost, in the goals' order; comes on the scheduler's thread. Takes less
    /// than to ask for each.
    public CompletionStage<List<Double>> costs(Pose2d mapFromStart, List<Pose2d> mapFromGoals) {
        if (planner.isEmpty()) {
            return CompletableFuture.completedStage(
                    mapFromGoals.stream().map(mapFromStart::distanceTo).toList());
        }
        return planner.get()
                .costs(mapFromStart, mapFromGoals, near)
                .exceptionally(_ -> Collections.nCopies(mapFromGoals.size(), Double.POSITIVE_INFINITY));
    }
}
