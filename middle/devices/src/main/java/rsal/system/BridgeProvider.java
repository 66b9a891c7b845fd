package rsal.system;

import java.io.IOException;
import java.net.InetSocketAddress;
import rsal.time.Scheduler;

/// A way to offer the robots of a run, whatever robot system they are of, to programs that speak another
/// system's protocol. Found by [java.util.ServiceLoader] and named by its key (`rsal bridge player`). What each
/// owes to the robots that its clients drive says `rsal.testkit.contract.CommandTimeoutContract`.
public interface BridgeProvider {
    /// `player`
    String key();

    /// For people: a sentence.
    String description();

    /// Where those programs look when they are told nothing else.
    int defaultPort();

    /// Whether programs can hold back a run whose time is simulated ([Bridge#pace]).
    default boolean canPace() {
        return false;
    }

    /// What to try where ports are taken: for people, as sentences.
    default String portRemedy() {
        return "Maybe a program is there, such as another 'rsal bridge' ('ss -ltnp' shows it). Take other ports by --port P, or"
                + " any that are free by --port 0.";
    }

    /// Offers what the context holds from now on. Called on the scheduler's thread.
    ///
    /// @param at where to listen: at this port, and those after it if need be; port 0 for any that are free
    /// @throws IOException when nobody may listen there; its message is a sentence that says where
    Bridge open(InetSocketAddress at, BridgeContext context, Scheduler scheduler) throws IOException;
}
