package rsal.device;

import java.util.concurrent.CompletionStage;
import rsal.data.Path2d;
import rsal.data.Pose2d;

/// Finds ways. Asking moves nothing.
public interface Planner extends Device {
    CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal);

    sealed interface Result {
        /// @param cost length of the way [m], more where it is narrow: what to compare ways by
        record Found(Path2d path, double cost) implements Result {}

        record NoPath(String why) implements Result {}
    }
}
