package rsal.system;

import java.io.IOException;
import java.util.Optional;
import rsal.time.Scheduler;

/// A recording of the robots of one run. When writing fails, the run goes on and nothing more is recorded.
public interface RobotRecorder extends AutoCloseable {
    /// Records from now on, until the bridge is closed: at the end of the run, after which the recording is whole.
    /// Called once, on the scheduler's thread. What is recorded changes nothing in the run.
    ///
    /// @param context with the robots that are there; others join the bridge, and leave it
    /// @return a bridge without exported devices
    Bridge open(BridgeContext context, Scheduler scheduler);

    /// Why nothing more was written; empty while all is well. On any thread.
    Optional<IOException> failure();

    /// Ends the recording if no run did. Closing twice does nothing. On any thread.
    @Override
    void close();
}
