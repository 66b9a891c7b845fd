package rsal.player.device;

import java.time.Instant;
import rsal.player.message.Dio;
import rsal.player.wire.Address;

/// The beams and contacts of a gripper, which are inputs of a `dio`: the inner beam, the outer one, the left contact,
/// the right one.
final class PlayerBeams extends Limb {
    private int bits;

    PlayerBeams(Address address) {
        super(address);
    }

    @Override
    public void take(Instant time, Record body) {
        if (body instanceof Dio.Values(int count, int values)) {
            bits = count >= Integer.SIZE ? values : values & (1 << Math.max(0, count)) - 1;
            changed(time);
        }
    }

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
