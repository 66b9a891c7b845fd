package rsal.system;

import java.io.IOException;
import java.time.Duration;
import java.util.List;
import java.util.Optional;
import rsal.robot.Robot;

/// Robots that are offered to others. Called on the scheduler's thread.
public interface Bridge extends AutoCloseable {
    /// What is offered, in an order that people can follow.
    List<ExportedDevice> offers();

    /// A robot has come: it is offered, too, unless others have written down what is to be.
    ///
    /// @return what is offered of it
    /// @throws IOException when nobody may listen where it would be; its message is a sentence that says where
    List<ExportedDevice> join(Robot robot) throws IOException;

    /// A robot has gone for good: those whom it was offered to are let go of.
    void leave(String robot);

    /// Whether a program that has data sent at its own pace has yet to ask for what there is. A run that goes
    /// as fast as it can waits for such, so that they miss nothing; not for one that has not asked for a
    /// second.
    default boolean isBehind() {
        return false;
    }

    /// For how long simulated time goes on at once at most, before commands are taken again; empty for a whole step.
    default Optional<Duration> grain() {
        return Optional.empty();
    }

    /// How the run may go on. Asked between two [grains][#grain] of simulated time, and again while it waits.
    default Pace pace() {
        return Pace.FREE;
    }

    /// How programs that follow the run's time hold it back.
    enum Pace {
        /// As fast as people want.
        FREE,

        /// Also, as all programs that follow have come as far.
        FOLLOWED,

        /// At most at real time, as no program follows yet.
        UNFOLLOWED,

        /// Not now: a program that follows has not come as far.
        AWAITED
    }

    /// Lets go of the robots; those that were driven over it stop. Closing twice does nothing.
    @Override
    void close();
}
