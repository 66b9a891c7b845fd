package rsal.ros2.bridge;

import rsal.device.Navigator.Result;
import rsal.ros2.action.ActionServer.Status;
import rsal.ros2.message.PlanningError;

/// How a drive of a navigator of ours ended, as Nav2 tells it.
///
/// @param code of Nav2's errors; 0 for none
/// @param why for people; empty when it was reached
record NavigationEnding(Status status, int code, String why) {
    private static final int NO_PROGRESS = 105; // failed to make progress

    /// @param isCanceling whether the client wanted it
    static NavigationEnding of(Result result, boolean isCanceling) {
        return switch (result) {
            case Result.Reached _ -> new NavigationEnding(Status.SUCCEEDED, 0, "");
            case Result.Cancelled(String why) ->
                new NavigationEnding(isCanceling ? Status.CANCELED : Status.ABORTED, 0, why);
            case Result.NoPath(String why) ->
                new NavigationEnding(Status.ABORTED, PlanningError.NO_VALID_PATH.code(), why);
            case Result.Stuck stuck -> new NavigationEnding(Status.ABORTED, NO_PROGRESS, stuck.why());
        };
    }
}
