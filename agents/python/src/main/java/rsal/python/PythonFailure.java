package rsal.python;

import java.util.List;
import java.util.Map;
import rsal.settings.OwnCode;

/// Code of an agent in Python has failed, or its process has. The message is for people: `hunter.py:42 in on_scan:
/// KeyError: 'prey'`. The stack is that of Python.
final class PythonFailure extends RuntimeException {
    private static final long serialVersionUID = 1;
    private static final int FRAME = 3; // file, line, function

    PythonFailure(String message) {
        super(message);
        setStackTrace(new StackTraceElement[0]);
    }

    /// @param words of Python about it
    static PythonFailure of(Map<?, ?> words) {
        var failure = new PythonFailure(String.valueOf(words.get("message")));
        if (words.get("frames") instanceof List<?> frames) {
            failure.setStackTrace(frames.stream()
                    .map(frame -> (List<?>) frame)
                    .filter(frame -> frame.size() == FRAME)
                    .map(frame -> new StackTraceElement(
                            "python",
                            String.valueOf(frame.get(2)),
                            String.valueOf(frame.getFirst()),
                            FromWords.integer(frame.get(1))))
                    .toArray(StackTraceElement[]::new));
        }
        return failure;
    }

    /// What RSAL refused, where the agent asked for it.
    ///
    /// @param place in Python
    static PythonFailure at(String place, RuntimeException why) {
        String words = OwnCode.words(why);
        var failure = new PythonFailure(place.isEmpty() ? words : "%s: %s".formatted(place, words));
        failure.initCause(why);
        return failure;
    }
}
