package rsal.agent.team;

import java.util.concurrent.CompletionStage;
import rsal.data.Pose2d;

/// What ways cost a robot. Asking moves nothing.
public interface PathCostEstimator {
    /// @return length of the way [m], more where it is narrow; +∞ where none leads. Comes on the scheduler's thread.
    CompletionStage<Double> cost(Pose2d mapFromStart, Pose2d mapFromGoal);
}
