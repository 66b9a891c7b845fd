package rsal.device;

import java.util.concurrent.CompletionStage;
import rsal.data.Path2d;
import rsal.data.Pose2d;

/// Finds ways. Asking moves nothing: so costs can be compared and it can be asked whether a place can be reached.
public interface Planner extends Device {
    CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal);

    sealed interface Result {
        /// @param cost length of the way [m], more where it is narrow: what to compare ways by
        /// @param offGoal how far from the goal it ends [m], when the robot can't be there but near it; else 0
        record Found(Path2d path, double cost, double offGoal) implements Result {}

        record NoPath(String why) implements Result {}
    }
}
