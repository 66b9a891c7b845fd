package rsal.ros2.tf;

import java.util.Optional;
import rsal.ros2.message.FrameTransform;

/// What a [TransformBuffer] answers.
public sealed interface TransformLookup {
    default Optional<FrameTransform> transform() {
        return this instanceof Found found ? Optional.of(found.targetFromSource()) : Optional.empty();
    }

    /// Whether it failed for a reason.
    default boolean isFailure(Reason reason) {
        return this instanceof Failure failure && failure.reason() == reason;
    }

    /// Whether a chain of transforms joins the two frames, though maybe not at that time.
    default boolean isConnected() {
        return this instanceof Found || isFailure(Reason.PAST) || isFailure(Reason.FUTURE);
    }

    record Found(FrameTransform targetFromSource) implements TransformLookup {}

    /// @param frame whose transforms are missing
    /// @param other the frame to which none lead, for [Reason#NOT_CONNECTED]; empty for others
    /// @param known the stamp nearest to the wanted one, for [Reason#PAST] and [Reason#FUTURE] [ns]
    /// @param wanted stamp, for the same [ns]
    record Failure(Reason reason, String frame, String other, long known, long wanted) implements TransformLookup {
        static Failure of(Reason reason, String frame, String other) {
            return new Failure(reason, frame, other, 0, 0);
        }

        /// For people: a sentence.
        public String message() {
            return switch (reason) {
                case UNKNOWN_FRAME -> "No transform (TF) names the frame '%s'.".formatted(frame);
                case NOT_CONNECTED -> "No transforms (TF) connect the frames '%s' and '%s'.".formatted(frame, other);
                case LOOP -> "The transforms (TF) above the frame '%s' form a loop, or are too many.".formatted(frame);
                case PAST ->
                    "The frame '%s' has transforms (TF) from %s on, but %s is needed."
                            .formatted(frame, seconds(known), seconds(wanted));
                case FUTURE ->
                    "The frame '%s' has transforms (TF) until %s, but %s is needed."
                            .formatted(frame, seconds(known), seconds(wanted));
            };
        }

        private static String seconds(long stamp) {
            return "%.3f s".formatted(stamp / 1e9);
        }
    }

    /// Why there is no transform.
    enum Reason {
        /// Neither the child nor the parent of any transform.
        UNKNOWN_FRAME,

        /// The two frames are in different trees.
        NOT_CONNECTED,

        /// A frame is above itself, or its tree has more levels than any robot.
        LOOP,

        /// The stamp is older than all of a frame's transforms.
        PAST,

        /// The stamp is newer than all of a frame's transforms.
        FUTURE
    }
}
