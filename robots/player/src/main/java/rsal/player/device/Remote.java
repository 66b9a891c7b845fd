package rsal.player.device;

import java.time.Instant;
import java.util.List;
import rsal.player.wire.Address;

/// Something of ours that a device of a Player server is behind. Called on the scheduler's thread.
interface Remote {
    /// Which device, without host and port.
    Address address();

    /// Requests without a body that are to be answered before it gets any data, each time when the connection is new.
    default List<Integer> questions() {
        return List.of();
    }

    /// An answer to one of its questions; there is none when the server refuses.
    default void answered(Record body) {}

    /// It gets data from now on.
    default void connected() {}

    /// @param time when that was measured
    void take(Instant time, Record body);

    /// All that is new for now was taken.
    default void delivered() {}

    /// There is no connection any more, or the server has no such device.
    void lost(String reason);

    /// Time has passed.
    default void look(Instant now) {}

    /// Nobody wants anything of it any more: what moves stops, what was left behind goes.
    default void end() {}
}
