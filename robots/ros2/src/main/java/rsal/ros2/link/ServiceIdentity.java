package rsal.ros2.link;

import static rsal.rtps.wire.ParameterId.RELATED_SAMPLE_IDENTITY;
import static rsal.rtps.wire.ParameterId.RELATED_SAMPLE_IDENTITY_OF_FAST_DDS;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.ParameterList;

/// What joins requests and replies. Implementations of DDS have two ways: Cyclone DDS has 16 bytes in front of the
/// message (`rmw_cyclonedds`: the client's id and a number), all others a sample identity beside it (DDS-RPC 1.0,
/// 7.8.2).
final class ServiceIdentity {
    static final int BEGIN = 4; // bytes: the encapsulation header, in front of all
    static final int HEADER = 16; // bytes
    private static final int CYCLONE = 0x0110;
    private static final int BYTES = Guid.BYTES + Long.BYTES;

    private ServiceIdentity() {}

    /// Whether an endpoint's participant uses bytes in front of the message.
    static boolean isHeader(Guid endpoint) {
        return endpoint.prefix().vendor() == CYCLONE;
    }

    /// The identity beside a message: a GUID and a number.
    static Optional<ByteBuffer> in(ParameterList inlineQos) {
        return inlineQos
                .find(RELATED_SAMPLE_IDENTITY, BYTES)
                .or(() -> inlineQos.find(RELATED_SAMPLE_IDENTITY_OF_FAST_DDS, BYTES));
    }

    /// Puts it there under both of its numbers, as older and newer peers know one each.
    static void put(ParameterList.Writer list, Guid guid, long number) {
        Consumer<ByteBuffer> identity = to -> {
            guid.write(to);
            to.putInt((int) (number >> 32)).putInt((int) number);
        };
        list.put(RELATED_SAMPLE_IDENTITY_OF_FAST_DDS, identity).put(RELATED_SAMPLE_IDENTITY, identity);
    }

    /// A message without the bytes in front.
    ///
    /// @param payload which has them
    static byte[] without(byte[] payload) {
        byte[] message = Arrays.copyOf(payload, payload.length - HEADER);
        System.arraycopy(payload, BEGIN + HEADER, message, BEGIN, message.length - BEGIN);
        return message;
    }

    /// A message with bytes in front.
    ///
    /// @param header with an encapsulation header, and the bytes
    static byte[] with(byte[] header, byte[] message) {
        byte[] payload = Arrays.copyOf(header, message.length + HEADER);
        System.arraycopy(message, 0, payload, 0, BEGIN);
        System.arraycopy(message, BEGIN, payload, BEGIN + HEADER, message.length - BEGIN);
        return payload;
    }
}
