package rsal.player.device;

import java.time.Instant;
import java.util.function.Consumer;
import rsal.player.wire.Address;

/// Something that a server has as a device of its own and that is part of one of ours.
abstract class Limb implements Remote {
    private final Address address;
    private Consumer<Instant> listener = _ -> {};

    Limb(Address address) {
        this.address = address;
    }

    /// Has somebody told when it is another than before.
    final void onChange(Consumer<Instant> reported) {
        listener = reported;
    }

    final void changed(Instant time) {
        listener.accept(time);
    }

    @Override
    public final Address address() {
        return address;
    }

    /// That of which it is part says so.
    @Override
    public final void lost(String reason) {}
}
