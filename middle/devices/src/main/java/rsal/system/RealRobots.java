package rsal.system;

import java.time.Duration;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What can be set of systems of real robots, by the same words for all.
public final class RealRobots {
    public static final Parameter<Double> WATCHDOG =
            Parameter.number("watchdog", 0.5, 0.1, 10, "s", "A base stops after this time without a command.");
    public static final Parameter<Boolean> ARMED = Parameter.flag(
            "armed", false, "Whether motors are on from the beginning. If not, robots stand until somebody arms them.");
    public static final Parameter<Double> WAIT = Parameter.number(
            "wait", 8, 3, 3600, "s", "How long a run waits for its robots before it reports those that are missing.");
    public static final Parameter<Boolean> LATE = Parameter.flag(
            "late",
            false,
            "Whether robots that are still missing then may join later. If not, the run ends with a message.");

    /// How long a run waits for its robots.
    ///
    /// @param patience how long it waits; a system may begin again with each robot that it finds
    /// @param late whether robots that are not found by then may join later
    public record Waiting(Duration patience, boolean late) {
        /// Eight seconds, and no robot joins later.
        public static final Waiting USUAL = new Waiting(Duration.ofSeconds(8), false);

        /// @param settings with [#WAIT] and [#LATE]
        public static Waiting of(Arguments settings) {
            return new Waiting(settings.seconds(WAIT), settings.get(LATE));
        }
    }

    private RealRobots() {}
}
