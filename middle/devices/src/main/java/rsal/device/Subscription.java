package rsal.device;

/// An interest in something, until it is cancelled.
@FunctionalInterface
public interface Subscription extends AutoCloseable {
    /// No callback comes after this, not even one that is already due. Cancelling twice does nothing.
    void cancel();

    @Override
    default void close() {
        cancel();
    }
}
