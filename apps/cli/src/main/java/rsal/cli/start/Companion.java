package rsal.cli.start;

import java.util.Map;
import java.util.Optional;
import java.util.function.LongFunction;

/// The program that has started this process to work for it, as the Python package does. When it has ended, however
/// it did, so does this process: a killed program can end nobody any more.
public final class Companion {
    /// Environment variable with the number of its process.
    public static final String VARIABLE = "RSAL_END_WITH";

    private Companion() {}

    /// Ends this process when the other one has ended, as the signal to terminate would. At most five seconds later.
    ///
    /// @throws IllegalArgumentException in a sentence for people, when the variable names no process
    public static void watch(Map<String, String> environment) {
        String number = environment.getOrDefault(VARIABLE, "");
        if (!number.isEmpty()) {
            watch(number, ProcessHandle::of, () -> System.exit(143)); // 128 and the number of SIGTERM
        }
    }

    static void watch(String number, LongFunction<Optional<ProcessHandle>> processes, Runnable end) {
        long id;
        try {
            id = Long.parseLong(number);
        } catch (NumberFormatException e) {
            throw new IllegalArgumentException(
                    "The environment variable %s must be the number of a process, not '%s'."
                            .formatted(VARIABLE, number),
                    e);
        }
        processes
                .apply(id)
                .ifPresentOrElse(
                        other -> {
                            var _ = other.onExit().thenRun(end);
                        },
                        end);
    }
}
