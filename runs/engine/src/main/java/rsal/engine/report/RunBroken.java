package rsal.engine.report;

import java.util.Optional;
import java.util.function.Supplier;
import rsal.settings.OwnCode;

/// A run could not go on. The message names what broke it.
public final class RunBroken extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final int DEEPEST = 20; // causes that are looked at: they may go in a circle

    public RunBroken(String message) {
        super(message);
    }

    public RunBroken(String culprit, Throwable cause) {
        super("%s failed: %s".formatted(culprit, OwnCode.words(cause)), cause);
    }

    /// The lack of memory that something failed of, at first hand or not; empty when it was not that.
    public static Optional<OutOfMemoryError> lackOfMemory(Throwable failure) {
        Throwable cause = failure;
        for (int depth = 0; cause != null && depth < DEEPEST; depth++) {
            if (cause instanceof OutOfMemoryError lack) {
                return Optional.of(lack);
            }
            cause = cause.getCause();
        }
        return Optional.empty();
    }

    /// Does what may fail; then its owner is to blame.
    public static <T> T blaming(String owner, Supplier<T> work) {
        try {
            return work.get();
        } catch (RuntimeException | Error e) {
            throw new RunBroken(owner, e);
        }
    }

    /// The same of what gives nothing back.
    public static void blaming(String owner, Runnable work) {
        blaming(owner, () -> {
            work.run();
            return Optional.empty();
        });
    }
}
