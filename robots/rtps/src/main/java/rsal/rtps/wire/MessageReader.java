package rsal.rtps.wire;

import java.nio.BufferUnderflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Content;
import rsal.rtps.wire.Submessage.Data;
import rsal.rtps.wire.Submessage.DataFragments;
import rsal.rtps.wire.Submessage.Gap;
import rsal.rtps.wire.Submessage.Heartbeat;
import rsal.rtps.wire.Submessage.NackFragments;

/// Reads a datagram. What it does not know it skips, as the protocol demands.
public final class MessageReader {
    static final int HEADER = 20; // bytes
    static final int RTPS = 0x52545053;
    static final int VERSION = 2; // the major one

    private MessageReader() {}

    /// Who sent a submessage, to whom and when.
    ///
    /// @param destination [GuidPrefix#UNKNOWN] for everybody
    /// @param timestamp [ns] since 1970; −1 where none was sent
    public record Origin(GuidPrefix source, GuidPrefix destination, long timestamp) {
        public static final long NO_TIME = -1;

        public Guid guid(EntityId entity) {
            return new Guid(source, entity);
        }
    }

    /// Gets what was read.
    public interface Receiver {
        void receive(Origin origin, Submessage submessage);
    }

    /// @param datagram from its position to its limit; payloads are parts of it
    /// @throws InvalidRtps when it is not a message, or a submessage is malformed; those before it were received
    public static void read(ByteBuffer datagram, Receiver receiver) throws InvalidRtps {
        ByteBuffer bytes = datagram.slice().order(ByteOrder.BIG_ENDIAN);
        if (bytes.limit() < HEADER || bytes.getInt() != RTPS) {
            throw new InvalidRtps("%d bytes are not a message of RTPS.".formatted(bytes.limit()));
        }
        int version = bytes.get();
        if (version != VERSION) {
            throw new InvalidRtps("Version %d of RTPS is not read, only 2.".formatted(version));
        }
        bytes.position(8); // minor version and vendor don't matter
        var origin = new Origin(GuidPrefix.read(bytes), GuidPrefix.UNKNOWN, Origin.NO_TIME);
        while (bytes.remaining() >= 4) {
            int id = bytes.get() & 0xff;
            int flags = bytes.get() & 0xff;
            bytes.order((flags & Flag.LITTLE_ENDIAN) != 0 ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
            int length = bytes.getShort() & 0xffff;
            if (length > bytes.remaining()) {
                throw new InvalidRtps("Submessage 0x%02x has %d bytes, of which %d are there."
                        .formatted(id, length, bytes.remaining()));
            }
            boolean toTheEnd = length == 0 && id != SubmessageId.PAD && id != SubmessageId.INFO_TIME;
            int end = toTheEnd ? bytes.limit() : bytes.position() + length;
            ByteBuffer body =
                    bytes.slice(bytes.position(), end - bytes.position()).order(bytes.order());
            try {
                origin = read(id, flags, body, origin, receiver);
            } catch (BufferUnderflowException e) {
                throw new InvalidRtps("Submessage 0x%02x of %d bytes is too short.".formatted(id, body.limit()));
            }
            bytes.position(end);
        }
    }

    /// @return what counts for the submessages behind it
    private static Origin read(int id, int flags, ByteBuffer body, Origin origin, Receiver receiver)
            throws InvalidRtps {
        switch (id) {
            case SubmessageId.INFO_TIME -> {
                long time = (flags & Flag.INVALIDATE) != 0 ? Origin.NO_TIME : Timestamp.readTime(body);
                return new Origin(origin.source, origin.destination, time);
            }
            case SubmessageId.INFO_DESTINATION -> {
                return new Origin(origin.source, GuidPrefix.read(body), origin.timestamp);
            }
            case SubmessageId.INFO_SOURCE -> {
                body.getLong(); // what is unused, version and vendor
                return new Origin(GuidPrefix.read(body), GuidPrefix.UNKNOWN, Origin.NO_TIME);
            }
            case SubmessageId.ACKNACK -> receiver.receive(origin, ackNack(flags, body));
            case SubmessageId.HEARTBEAT -> receiver.receive(origin, heartbeat(flags, body));
            case SubmessageId.GAP -> receiver.receive(origin, gap(body));
            case SubmessageId.DATA -> receiver.receive(origin, data(flags, body));
            case SubmessageId.DATA_FRAGMENTS -> receiver.receive(origin, fragments(flags, body));
            case SubmessageId.NACK_FRAGMENTS -> receiver.receive(origin, nackFragments(body));
            default -> {} // as the protocol demands
        }
        return origin;
    }

    private static AckNack ackNack(int flags, ByteBuffer body) throws InvalidRtps {
        return new AckNack(
                EntityId.read(body),
                EntityId.read(body),
                NumberSet.readNumbers(body),
                body.getInt(),
                (flags & Flag.FINAL) != 0);
    }

    private static Heartbeat heartbeat(int flags, ByteBuffer body) throws InvalidRtps {
        var heartbeat = new Heartbeat(
                EntityId.read(body),
                EntityId.read(body),
                SequenceNumber.read(body),
                SequenceNumber.read(body),
                body.getInt(),
                (flags & Flag.FINAL) != 0);
        if (heartbeat.first() < 1 || heartbeat.last() < heartbeat.first() - 1) {
            throw new InvalidRtps("A heartbeat from %d to %d is none.".formatted(heartbeat.first(), heartbeat.last()));
        }
        return heartbeat;
    }

    private static Gap gap(ByteBuffer body) throws InvalidRtps {
        var gap = new Gap(
                EntityId.read(body), EntityId.read(body), SequenceNumber.read(body), NumberSet.readNumbers(body));
        if (gap.start() < 1 || gap.more().base() < gap.start()) {
            throw new InvalidRtps("A gap from %d to %d is none."
                    .formatted(gap.start(), gap.more().base()));
        }
        return gap;
    }

    private static Data data(int flags, ByteBuffer body) throws InvalidRtps {
        int qosAt = 4 + qosOffset(body);
        EntityId reader = EntityId.read(body);
        EntityId writer = EntityId.read(body);
        long number = number(body);
        ParameterList qos = inlineQos(flags, body, qosAt);
        Content content =
                (flags & Flag.DATA) != 0 ? Content.DATA : (flags & Flag.KEY) != 0 ? Content.KEY : Content.NONE;
        return new Data(reader, writer, number, qos, content, body.slice());
    }

    private static DataFragments fragments(int flags, ByteBuffer body) throws InvalidRtps {
        int qosAt = 4 + qosOffset(body);
        EntityId reader = EntityId.read(body);
        EntityId writer = EntityId.read(body);
        long number = number(body);
        int first = body.getInt();
        int count = body.getShort() & 0xffff;
        int size = body.getShort() & 0xffff;
        int whole = body.getInt();
        ParameterList qos = inlineQos(flags, body, qosAt);
        var part = new DataFragments(reader, writer, number, qos, first, count, size, whole, body.slice());
        check(part);
        return part;
    }

    private static void check(DataFragments part) throws InvalidRtps {
        long begin = (part.first() - 1L) * part.fragmentSize();
        long length = Math.min((long) part.count() * part.fragmentSize(), part.sampleSize() - begin);
        if (part.first() < 1
                || part.count() < 1
                || part.fragmentSize() < 1
                || begin + (part.count() - 1L) * part.fragmentSize() >= part.sampleSize()
                || part.part().remaining() < length) {
            throw new InvalidRtps("Fragments %d and on, %d of %d bytes, are none of a sample of %d bytes."
                    .formatted(part.first(), part.count(), part.fragmentSize(), part.sampleSize()));
        }
    }

    private static NackFragments nackFragments(ByteBuffer body) throws InvalidRtps {
        return new NackFragments(
                EntityId.read(body), EntityId.read(body), number(body), NumberSet.readFragments(body), body.getInt());
    }

    private static int qosOffset(ByteBuffer body) {
        body.getShort(); // extra flags
        return body.getShort() & 0xffff;
    }

    private static long number(ByteBuffer body) throws InvalidRtps {
        long number = SequenceNumber.read(body);
        if (number < 1) {
            throw new InvalidRtps("A sample has the number %d; the first one is 1.".formatted(number));
        }
        return number;
    }

    /// @param at where it begins, behind fields that this version does not know
    private static ParameterList inlineQos(int flags, ByteBuffer body, int at) throws InvalidRtps {
        if (at < body.position() || at > body.limit()) {
            throw new InvalidRtps("Inline QoS of a sample begins at %d of %d bytes.".formatted(at, body.limit()));
        }
        body.position(at);
        return (flags & Flag.INLINE_QOS) != 0 ? ParameterList.read(body) : ParameterList.EMPTY;
    }

    /// Of submessages; which bit means what depends on the submessage.
    static final class Flag {
        static final int LITTLE_ENDIAN = 0x01;
        static final int FINAL = 0x02;
        static final int INVALIDATE = 0x02;
        static final int INLINE_QOS = 0x02;
        static final int DATA = 0x04;
        static final int KEY = 0x08;

        private Flag() {}
    }
}
