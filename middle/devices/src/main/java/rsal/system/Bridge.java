package rsal.system;

import java.util.List;

/// Robots that are offered to others. Called on the scheduler's thread.
public interface Bridge extends AutoCloseable {
    /// What is offered, in an order that people can follow.
    List<Offer> offers();

    /// Lets go of the robots; those that were driven over it stop. Closing twice does nothing.
    @Override
    void close();

    /// @param port where
    /// @param name as others know it there (`position2d:0`)
    /// @param device of ours ([rsal.device.DeviceInfo#id])
    record Offer(int port, String name, String device) {}
}
