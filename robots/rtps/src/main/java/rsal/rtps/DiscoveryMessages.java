package rsal.rtps;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.rtps.WriterProxy.Arrival;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.InvalidRtps;
import rsal.rtps.wire.MessageWriter;
import rsal.rtps.wire.ParameterId;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage.Content;

/// Payloads of what participants tell of themselves and their endpoints: parameter lists, little endian (DDSI-RTPS 2.5,
/// 9.6.3).
final class DiscoveryMessages {
    private static final int MOST_ANNOUNCED = 16 << 10; // B of what one participant or endpoint says of itself
    private static final byte[] ENCAPSULATION = {0, 3, 0, 0}; // PL_CDR_LE
    private static final int PL_CDR_BE = 2;
    private static final int PL_CDR_LE = 3;
    private static final int GONE = 0b11; // disposed and unregistered, in STATUS_INFO

    private DiscoveryMessages() {}

    /// Writes what a participant says of itself.
    static void announce(MessageWriter to, byte[] announced) {
        participant(to, 1, Content.DATA, Optional.empty(), announced);
    }

    /// Writes that a participant leaves.
    static void leave(MessageWriter to, GuidPrefix prefix) {
        var guid = new Guid(prefix, EntityId.PARTICIPANT);
        participant(to, 2, Content.KEY, gone(guid), key(ParameterId.PARTICIPANT_GUID, guid));
    }

    private static void participant(
            MessageWriter to,
            long number,
            Content content,
            Optional<Consumer<ParameterList.Writer>> inlineQos,
            byte[] payload) {
        to.data(EntityId.PARTICIPANT_READER, EntityId.PARTICIPANT_WRITER, number, inlineQos, content, payload);
    }

    /// A list that names nothing but a participant or endpoint.
    static byte[] key(int id, Guid guid) {
        return parameters(list -> list.put(id, guid::write));
    }

    /// Inline QoS of what is not there any more.
    static Optional<Consumer<ParameterList.Writer>> gone(Guid guid) {
        return Optional.of(list -> list.put(ParameterId.KEY_HASH, guid::write)
                .put(ParameterId.STATUS_INFO, to -> to.put(new byte[] {0, 0, 0, GONE})));
    }

    /// A payload.
    static byte[] parameters(Consumer<ParameterList.Writer> write) {
        var bytes = ByteBuffer.allocate(MOST_ANNOUNCED).order(ByteOrder.LITTLE_ENDIAN);
        bytes.put(ENCAPSULATION);
        var list = new ParameterList.Writer(bytes.slice().order(ByteOrder.LITTLE_ENDIAN));
        write.accept(list);
        int end = ENCAPSULATION.length + list.end();
        return Arrays.copyOf(bytes.array(), end);
    }

    /// Whether a participant or endpoint is said to be gone.
    static boolean isGone(ParameterList inlineQos) {
        return inlineQos
                .find(ParameterId.STATUS_INFO, Integer.BYTES)
                .map(info -> (info.get(Integer.BYTES - 1) & GONE) != 0) // octets, whatever their order
                .orElse(false);
    }

    /// Which endpoint a sample is about.
    static Optional<Guid> key(Arrival sample) throws InvalidRtps {
        Optional<Guid> hash =
                sample.inlineQos().find(ParameterId.KEY_HASH, Guid.BYTES).map(Guid::read);
        if (hash.isPresent() || sample.content() == Content.NONE) {
            return hash;
        }
        return list(sample.payload())
                .find(ParameterId.ENDPOINT_GUID, Guid.BYTES)
                .map(Guid::read);
    }

    /// What a payload says.
    static ParameterList list(ByteBuffer payload) throws InvalidRtps {
        ByteBuffer bytes = payload.slice().order(ByteOrder.BIG_ENDIAN);
        int encapsulation = bytes.remaining() < 4 ? -1 : bytes.getInt() >>> 16;
        if (encapsulation != PL_CDR_BE && encapsulation != PL_CDR_LE) {
            throw new InvalidRtps("What a participant tells of itself is not a parameter list.");
        }
        bytes.order(encapsulation == PL_CDR_LE ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        return ParameterList.read(bytes);
    }
}
