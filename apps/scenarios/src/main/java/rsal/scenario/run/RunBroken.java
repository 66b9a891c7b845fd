package rsal.scenario.run;

import java.util.function.Supplier;

/// A run could not go on. The message names what broke it.
public final class RunBroken extends RuntimeException {
    private static final long serialVersionUID = 1;

    RunBroken(String message) {
        super(message);
    }

    RunBroken(String culprit, Throwable cause) {
        super("%s failed: %s".formatted(culprit, words(cause)), cause);
    }

    /// Does what may fail; then its owner is to blame.
    static <T> T blaming(String owner, Supplier<T> work) {
        try {
            return work.get();
        } catch (RuntimeException | Error e) {
            throw new RunBroken(owner, e);
        }
    }

    private static String words(Throwable cause) {
        String message = cause.getMessage();
        return message == null ? cause.getClass().getSimpleName() : message;
    }
}
