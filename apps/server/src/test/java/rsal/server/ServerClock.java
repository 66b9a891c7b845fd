package rsal.server;

import java.time.Duration;
import org.awaitility.Awaitility;
import org.awaitility.core.ConditionFactory;

/// Waits for what the server does by its own clock.
public final class ServerClock {
    private ServerClock() {}

    /// Looks 50 times a second, on the test's own thread, for 20 s at most.
    public static ConditionFactory await() {
        return Awaitility.await()
                .pollInSameThread()
                .pollDelay(Duration.ZERO)
                .pollInterval(Duration.ofMillis(20))
                .atMost(Duration.ofSeconds(20));
    }
}
