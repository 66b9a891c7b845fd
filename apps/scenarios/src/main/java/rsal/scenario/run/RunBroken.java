package rsal.scenario.run;

/// A run could not go on. The message names what broke it.
public final class RunBroken extends RuntimeException {
    private static final long serialVersionUID = 1;

    RunBroken(String message) {
        super(message);
    }

    RunBroken(String culprit, Throwable cause) {
        super("%s failed: %s".formatted(culprit, words(cause)), cause);
    }

    private static String words(Throwable cause) {
        String message = cause.getMessage();
        return message == null ? cause.getClass().getSimpleName() : message;
    }
}
