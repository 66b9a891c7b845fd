package rsal.player.device;

import java.time.Instant;
import java.util.function.Consumer;
import rsal.player.message.Dio;
import rsal.player.wire.Address;

/// The beams and contacts of a gripper, which are inputs of a `dio`: the inner beam, the outer one, the left contact,
/// the right one.
final class PlayerBeams implements Remote {
    private final Address address;
    private Consumer<Instant> listener = _ -> {};
    private int bits;

    PlayerBeams(Address address) {
        this.address = address;
    }

    void onChange(Consumer<Instant> told) {
        listener = told;
    }

    @Override
    public Address address() {
        return address;
    }

    @Override
    public void take(Instant time, Record body) {
        if (body instanceof Dio.Values(int count, int values)) {
            bits = count >= Integer.SIZE ? values : values & (1 << Math.max(0, count)) - 1;
            listener.accept(time);
        }
    }

    @Override
    public void lost(String reason) {}

    boolean inner() {
        return (bits & 1) != 0;
    }

    boolean outer() {
        return (bits & 2) != 0;
    }

    boolean left() {
        return (bits & 4) != 0;
    }

    boolean right() {
        return (bits & 8) != 0;
    }
}
