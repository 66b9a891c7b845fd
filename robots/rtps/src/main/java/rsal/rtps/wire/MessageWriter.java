package rsal.rtps.wire;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.rtps.wire.MessageReader.Flag;
import rsal.rtps.wire.Submessage.AckNack;
import rsal.rtps.wire.Submessage.Gap;
import rsal.rtps.wire.Submessage.Heartbeat;
import rsal.rtps.wire.Submessage.NackFragments;

/// Writes datagrams, one after the other, in one buffer. Little endian. Of one thread.
public final class MessageWriter {
    /// Most of a datagram over UDP and IPv4 [B].
    public static final int MOST = 65_507;

    /// What a datagram has beside the payload of a sample without inline QoS, at most [B]: the header, whom it is for,
    /// its time, the head of the sample and a heartbeat.
    public static final int OVERHEAD = MessageReader.HEADER + 16 + 12 + 36 + 32;

    private static final byte MINOR_VERSION = 3;
    private static final int SAMPLE_QOS_OFFSET = 16;
    private static final int FRAGMENT_QOS_OFFSET = 28;

    private final ByteBuffer bytes = ByteBuffer.allocate(MOST).order(ByteOrder.LITTLE_ENDIAN);
    private final GuidPrefix source;

    /// @param source who sends them
    public MessageWriter(GuidPrefix source) {
        this.source = source;
    }

    /// Begins a message, which replaces the one before.
    ///
    /// @param destination for whom all of it is; [GuidPrefix#UNKNOWN] for everybody
    public MessageWriter begin(GuidPrefix destination) {
        bytes.clear();
        bytes.order(ByteOrder.BIG_ENDIAN).putInt(MessageReader.RTPS);
        bytes.put((byte) MessageReader.VERSION).put(MINOR_VERSION).putShort((short) source.vendor());
        bytes.order(ByteOrder.LITTLE_ENDIAN);
        source.write(bytes);
        if (!destination.equals(GuidPrefix.UNKNOWN)) {
            submessage(SubmessageId.INFO_DESTINATION, 0, () -> destination.write(bytes));
        }
        return this;
    }

    /// @param time of the samples that follow [ns] since 1970
    public MessageWriter timestamp(long time) {
        submessage(SubmessageId.INFO_TIME, 0, () -> Timestamp.writeTime(bytes, time));
        return this;
    }

    /// A sample.
    ///
    /// @param qos writes the inline QoS without its end; empty for none
    /// @param payload with its encapsulation header; its length is filled up to a multiple of 4
    public MessageWriter data(
            EntityId reader,
            EntityId writer,
            long number,
            Optional<Consumer<ParameterList.Writer>> qos,
            Submessage.Content content,
            byte[] payload) {
        int flags = (qos.isPresent() ? Flag.INLINE_QOS : 0)
                | switch (content) {
                    case NONE -> 0;
                    case DATA -> Flag.DATA;
                    case KEY -> Flag.KEY;
                };
        submessage(SubmessageId.DATA, flags, () -> {
            bytes.putShort((short) 0).putShort((short) SAMPLE_QOS_OFFSET);
            head(reader, writer, number);
            inline(qos);
            bytes.put(payload);
        });
        return this;
    }

    /// One fragment of a sample.
    ///
    /// @param fragment its number, from 1 on
    /// @param qos writes the inline QoS of the sample without its end; empty for none
    public MessageWriter fragment(
            EntityId reader,
            EntityId writer,
            long number,
            int fragment,
            int fragmentSize,
            Optional<Consumer<ParameterList.Writer>> qos,
            byte[] payload) {
        int flags = qos.isPresent() ? Flag.INLINE_QOS : 0;
        submessage(SubmessageId.DATA_FRAGMENTS, flags, () -> {
            bytes.putShort((short) 0).putShort((short) FRAGMENT_QOS_OFFSET);
            head(reader, writer, number);
            bytes.putInt(fragment)
                    .putShort((short) 1)
                    .putShort((short) fragmentSize)
                    .putInt(payload.length);
            inline(qos);
            int begin = (fragment - 1) * fragmentSize;
            bytes.put(payload, begin, Math.min(fragmentSize, payload.length - begin));
        });
        return this;
    }

    public MessageWriter heartbeat(Heartbeat heartbeat) {
        submessage(SubmessageId.HEARTBEAT, heartbeat.isFinal() ? Flag.FINAL : 0, () -> {
            heartbeat.reader().write(bytes);
            heartbeat.writer().write(bytes);
            SequenceNumber.write(bytes, heartbeat.first());
            SequenceNumber.write(bytes, heartbeat.last());
            bytes.putInt(heartbeat.count());
        });
        return this;
    }

    public MessageWriter ackNack(AckNack ackNack) {
        submessage(SubmessageId.ACKNACK, ackNack.isFinal() ? Flag.FINAL : 0, () -> {
            ackNack.reader().write(bytes);
            ackNack.writer().write(bytes);
            ackNack.missing().writeNumbers(bytes);
            bytes.putInt(ackNack.count());
        });
        return this;
    }

    public MessageWriter gap(Gap gap) {
        submessage(SubmessageId.GAP, 0, () -> {
            gap.reader().write(bytes);
            gap.writer().write(bytes);
            SequenceNumber.write(bytes, gap.start());
            gap.more().writeNumbers(bytes);
        });
        return this;
    }

    public MessageWriter nackFragments(NackFragments nack) {
        submessage(SubmessageId.NACK_FRAGMENTS, 0, () -> {
            nack.reader().write(bytes);
            nack.writer().write(bytes);
            SequenceNumber.write(bytes, nack.number());
            nack.missing().writeFragments(bytes);
            bytes.putInt(nack.count());
        });
        return this;
    }

    /// The message, until the next one is begun.
    public ByteBuffer message() {
        return bytes.slice(0, bytes.position());
    }

    private void head(EntityId reader, EntityId writer, long number) {
        reader.write(bytes);
        writer.write(bytes);
        SequenceNumber.write(bytes, number);
    }

    private void inline(Optional<Consumer<ParameterList.Writer>> qos) {
        qos.ifPresent(write -> {
            var list = new ParameterList.Writer(bytes);
            write.accept(list);
            list.end();
        });
    }

    private void submessage(int id, int flags, Runnable body) {
        bytes.put((byte) id).put((byte) (flags | Flag.LITTLE_ENDIAN)).putShort((short) 0);
        int start = bytes.position();
        body.run();
        while ((bytes.position() - start) % 4 != 0) {
            bytes.put((byte) 0); // submessages begin at multiples of 4
        }
        bytes.putShort(start - 2, (short) (bytes.position() - start));
    }
}
