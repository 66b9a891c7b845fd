package rsal.agent.message;

import java.util.Objects;
import rsal.data.Point2d;
import rsal.data.Pose2d;

/// What messages must say. They are checked where they are made, so that a slip ends the agent that made it and none of
/// those that hear of it.
public final class MessageCheck {
    private MessageCheck() {}

    /// @param what as the message calls it
    public static void given(String what, Object value) {
        Objects.requireNonNull(value, () -> "A message must say its '%s'.".formatted(what));
    }

    /// @param what is there
    public static void somewhere(String what, Point2d place) {
        given(what, place);
        isPlace(what, place, Double.isFinite(place.x()) && Double.isFinite(place.y()));
    }

    /// @param what is there
    public static void somewhere(String what, Pose2d pose) {
        given(what, pose);
        isPlace(what, pose, pose.isFinite());
    }

    private static void isPlace(String what, Object place, boolean finite) {
        if (!finite) {
            throw new IllegalArgumentException("A message must say where '%s' is, not '%s'.".formatted(what, place));
        }
    }
}
