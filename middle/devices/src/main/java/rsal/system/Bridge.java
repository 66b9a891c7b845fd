package rsal.system;

import java.io.IOException;
import java.util.List;
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

    /// Lets go of the robots; those that were driven over it stop. Closing twice does nothing.
    @Override
    void close();
}
