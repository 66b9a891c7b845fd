package rsal.system;

import java.io.IOException;
import java.net.InetSocketAddress;
import java.util.List;
import rsal.robot.Robot;
import rsal.time.Scheduler;

/// A way to offer the robots of a run, whatever robot system they are of, to programs that speak another system's
/// protocol. Found by [java.util.ServiceLoader] and named by its key (`rsal bridge player`).
public interface BridgeProvider {
    /// `player`
    String key();

    /// For people: a sentence.
    String description();

    /// Where those programs look when they are told nothing else.
    int defaultPort();

    /// Offers robots from now on. Called on the scheduler's thread.
    ///
    /// @param at where to listen; port 0 for any that is free
    /// @param robots that are there now, with all their devices
    /// @throws IOException when nobody may listen there
    Bridge open(InetSocketAddress at, List<Robot> robots, Scheduler scheduler) throws IOException;
}
