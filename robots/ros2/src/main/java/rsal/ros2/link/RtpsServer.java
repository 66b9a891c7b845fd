package rsal.ros2.link;

import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import java.util.function.Supplier;
import rsal.ros2.link.RosLink.Server;
import rsal.rtps.Reply;
import rsal.rtps.SampleListener.Sample;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.ParameterList;

/// Answers requests, each in the way of its client: see [ServiceIdentity].
final class RtpsServer {
    private final UdpParticipant participant;
    private final SampleWriter replies;
    private final Server server;
    private final LongSupplier date; // [ns] since 1970

    RtpsServer(UdpParticipant participant, SampleWriter replies, Server server, LongSupplier date) {
        this.date = date;
        this.participant = participant;
        this.replies = replies;
        this.server = server;
    }

    void take(Sample sample) {
        var payload = new byte[sample.payload().remaining()];
        sample.payload().get(payload);
        Supplier<Optional<String>> responseHash =
                () -> responseHash(sample.writer().prefix());
        Optional<ByteBuffer> identity = ServiceIdentity.in(sample.inlineQos());
        boolean isHeader = identity.isEmpty() && ServiceIdentity.isHeader(sample.writer());
        if (isHeader && payload.length < ServiceIdentity.BEGIN + ServiceIdentity.HEADER) {
            return;
        }
        if (isHeader) {
            byte[] header = Arrays.copyOfRange(payload, 0, ServiceIdentity.BEGIN + ServiceIdentity.HEADER);
            server.answer(ServiceIdentity.without(payload), responseHash)
                    .thenAccept(reply -> write(sample.writer(), Optional.empty(), ServiceIdentity.with(header, reply)));
        } else {
            Guid client = identity.map(Guid::read).orElse(sample.writer());
            long number = sample.number();
            Consumer<ParameterList.Writer> beside = list -> ServiceIdentity.put(list, client, number);
            server.answer(payload, responseHash).thenAccept(reply -> write(client, Optional.of(beside), reply));
        }
    }

    private void write(Guid client, Optional<Consumer<ParameterList.Writer>> beside, byte[] reply) {
        participant.write(replies, new Reply(client, date.getAsLong(), beside, reply));
    }

    /// Of the type of replies, as a client's participant announces it.
    private Optional<String> responseHash(GuidPrefix client) {
        String topic = replies.data().topic();
        return participant.endpoints().stream()
                .filter(each -> !each.isWriter()
                        && each.topic().equals(topic)
                        && each.guid().prefix().equals(client))
                .flatMap(each -> RtpsLink.typeHash(each.userData()).stream())
                .findFirst();
    }
}
