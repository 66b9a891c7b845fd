package rsal.ros2.rosbridge;

import java.io.IOException;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;

/// Answers of a server as messages.
final class ResponseMessages {
    private ResponseMessages() {}

    /// @param answer fails with what the server says, for people
    /// @param type of the message, in full
    /// @return in CDR; fails with the same
    static CompletionStage<byte[]> toCdr(
            CompletionStage<? extends WireValue> answer, MessageValues values, String type) {
        var message = new CompletableFuture<byte[]>();
        answer.whenComplete((value, error) -> {
            if (error != null) {
                message.completeExceptionally(reason(error));
                return;
            }
            try {
                message.complete(values.toCdr(type, value));
            } catch (InvalidMessage e) {
                message.completeExceptionally(new IOException(e.getMessage(), e));
            }
        });
        return message;
    }

    /// What a stage failed with, without what stages wrap it in.
    static Throwable reason(Throwable error) {
        @Nullable Throwable cause = error.getCause();
        return error instanceof CompletionException && cause != null ? cause : error;
    }
}
