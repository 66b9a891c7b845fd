package rsal.rtps;

import java.net.InetSocketAddress;
import java.util.Optional;
import java.util.Set;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.MessageWriter;
import rsal.rtps.wire.Submessage.Heartbeat;

/// Sends messages of a participant. What goes to one participant, one part after the other, goes in one datagram, as
/// far as that has room: most parts are small, and each datagram costs both sides a system call.
///
/// Who writes a part calls [#flush] soon, or what calls it does.
final class DatagramOutbox {
    /// What a part without a sample needs at most [B]: the head of a submessage, and a set of 256 numbers.
    private static final int SMALL = 80;

    private static final int HEARTBEAT = 32; // B
    private static final int INLINE_QOS = 128; // B

    private final MessageWriter messages;
    private final Transmitter network;
    private final int most;
    private Optional<Addressee> pending = Optional.empty();

    /// @param payload most of a sample that one datagram has [B]; one with several parts is not longer than one
    ///     with that and its inline QoS
    DatagramOutbox(GuidPrefix source, Transmitter network, int payload) {
        messages = new MessageWriter(source);
        this.network = network;
        most = Math.min(MessageWriter.MOST, payload + MessageWriter.OVERHEAD + INLINE_QOS);
    }

    void heartbeat(Addressee addressee, Heartbeat heartbeat) {
        next(addressee, HEARTBEAT).heartbeat(heartbeat);
    }

    /// Where the next submessage without a sample for somebody is written.
    MessageWriter to(Addressee addressee) {
        return next(addressee, SMALL);
    }

    /// Where a sample for somebody is written, or a part of one, with its time.
    ///
    /// @param payload its length [B]
    MessageWriter sample(Addressee addressee, int payload) {
        return next(addressee, payload + MessageWriter.OVERHEAD + INLINE_QOS);
    }

    private MessageWriter next(Addressee addressee, int part) {
        boolean isNext = pending.filter(addressee::equals).isPresent()
                && messages.message().remaining() + part <= most;
        if (!isNext) {
            flush();
            messages.begin(addressee.prefix());
            pending = Optional.of(addressee);
        }
        return messages;
    }

    /// Where a message for everybody is written, which [#announce] sends.
    MessageWriter toAll() {
        flush();
        return messages.begin(GuidPrefix.UNKNOWN);
    }

    /// @param known addresses of participants that hear the multicast group, if there is one
    void announce(Set<InetSocketAddress> known) {
        network.announce(messages.message(), known);
    }

    /// Sends what was written.
    void flush() {
        pending.ifPresent(
                addressee -> addressee.addresses().forEach(address -> network.send(messages.message(), address)));
        pending = Optional.empty();
    }
}
