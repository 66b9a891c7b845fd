package rsal.player.wire;

import java.nio.ByteBuffer;

/// What comes before each message's body: 40 bytes, each number but the time in four.
///
/// @param subtype which message of its kind and interface
/// @param time [s] of the sender's clock
/// @param sequence of a request to the interface `player`, which its answer repeats; else 0
/// @param size of the body [bytes]
public record Header(Address address, MessageKind kind, int subtype, double time, int sequence, int size) {
    public static final int BYTES = 40;

    /// Most that a body may have [bytes], as Player has it.
    public static final int MOST = 32 << 20;

    public static Header read(ByteBuffer from) throws MalformedException {
        var address = new Address(from.getInt(), from.getInt(), from.getInt(), from.getInt());
        var header = new Header(
                address, MessageKind.of(from.getInt()), from.getInt(), from.getDouble(), from.getInt(), from.getInt());
        if (header.size < 0 || header.size > MOST) {
            throw new MalformedException("A message can't have %s bytes; at most %d."
                    .formatted(Integer.toUnsignedString(header.size), MOST));
        }
        return header;
    }

    public void write(ByteBuffer to) {
        to.putInt(address.host())
                .putInt(address.robot())
                .putInt(address.interf())
                .putInt(address.index());
        to.putInt(kind.code()).putInt(subtype).putDouble(time).putInt(sequence).putInt(size);
    }
}
