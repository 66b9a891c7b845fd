package rsal.settings;

import java.util.Arrays;
import java.util.Objects;
import java.util.Optional;
import java.util.stream.Stream;

/// Code of users, in files beside their scenarios: where in it something failed.
public final class OwnCode {
    /// Name of class loaders of such code, by which stack traces tell it from that of RSAL.
    public static final String LOADER = "plugins";

    private static final int DEEPEST = 20; // causes that are looked at: they may go in a circle

    private OwnCode() {}

    /// What failed, for people. In code of users with the file and the line: `Index 2 out of bounds for length 1
    /// (ArrayIndexOutOfBoundsException in Cautious.java:51)`.
    public static String words(Throwable failure) {
        Throwable cause = culprit(failure).orElse(failure);
        String type = cause.getClass().getSimpleName();
        String message = Objects.requireNonNullElse(cause.getMessage(), type);
        return frame(cause)
                .map(frame -> "%s (%s in %s:%d)".formatted(message, type, frame.getFileName(), frame.getLineNumber()))
                .orElse(message);
    }

    /// Whether it was code of users that failed.
    public static boolean hasFailed(Throwable failure) {
        return culprit(failure).isPresent();
    }

    /// A place in a program, for people: `Hunter.java:110 in Hunt.hunt`.
    public static String place(StackTraceElement frame) {
        String type = frame.getClassName().replaceFirst(".*[.$]", "");
        String method = "%s.%s".formatted(type, frame.getMethodName());
        return frame.getFileName() == null || frame.getLineNumber() < 0
                ? method
                : "%s:%d in %s".formatted(frame.getFileName(), frame.getLineNumber(), method);
    }

    /// The deepest cause on whose way there is code of users.
    private static Optional<Throwable> culprit(Throwable failure) {
        return Stream.iterate(failure, Objects::nonNull, Throwable::getCause)
                .limit(DEEPEST)
                .filter(cause -> frame(cause).isPresent())
                .reduce((_, deeper) -> deeper);
    }

    private static Optional<StackTraceElement> frame(Throwable cause) {
        return Arrays.stream(cause.getStackTrace())
                .filter(frame -> LOADER.equals(frame.getClassLoaderName()))
                .findFirst();
    }
}
