package rsal.device;

/// How a device is. A reading like any other: listeners are told of changes, and it comes back by itself when it
/// can.
public sealed interface Health {
    /// It works.
    record Ok() implements Health {}

    /// No data for longer than it should take.
    record Stale(String reason) implements Health {}

    /// Its driver failed or its connection is gone.
    record Lost(String reason) implements Health {}

    static Health ok() {
        return new Ok();
    }

    default boolean isOk() {
        return this instanceof Ok;
    }
}
