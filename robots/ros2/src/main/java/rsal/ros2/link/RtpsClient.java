package rsal.ros2.link;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.atomic.AtomicLong;
import java.util.function.Consumer;
import java.util.function.LongSupplier;
import org.jspecify.annotations.Nullable;
import rsal.rtps.SampleListener.Sample;
import rsal.rtps.SampleReader;
import rsal.rtps.SampleWriter;
import rsal.rtps.UdpParticipant;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.ParameterList;

/// Requests and their replies, joined in the way of the server: see [ServiceIdentity].
final class RtpsClient {
    private static final int MOST_WAITING = 1_000; // requests
    private static final long UNKNOWN = -1L << 32; // number of a sample

    private final UdpParticipant participant;
    private final SampleWriter requests;
    private final LongSupplier date;
    private final long id;
    private final AtomicLong numbers = new AtomicLong();
    private final Map<Long, CompletableFuture<byte[]>> byNumber = new ConcurrentHashMap<>(); // of headers
    private final Map<Long, CompletableFuture<byte[]>> bySample = new ConcurrentHashMap<>(); // of identities
    private volatile @Nullable SampleReader replies;

    /// @param date of requests [ns] since 1970
    RtpsClient(UdpParticipant participant, SampleWriter requests, LongSupplier date) {
        this.participant = participant;
        this.date = date;
        this.requests = requests;
        Guid guid = requests.data().guid(); // unique among all clients
        id = guid.prefix().high() * 31
                + Integer.toUnsignedLong(guid.prefix().low()) * 257
                + guid.entity().octets();
    }

    void repliesTo(SampleReader reader) {
        replies = reader;
    }

    private SampleReader reader() {
        return Objects.requireNonNull(replies); // set at once
    }

    boolean isAvailable() {
        return !participant.readers(requests).isEmpty() && reader().matched() > 0;
    }

    CompletionStage<byte[]> call(byte[] request) {
        List<Guid> servers = participant.readers(requests);
        if (servers.isEmpty()) {
            return CompletableFuture.failedStage(new IllegalStateException(
                    "Nobody serves '%s'.".formatted(requests.data().topic())));
        }
        return ServiceIdentity.isHeader(servers.getFirst()) ? callByHeader(request) : callByIdentity(request);
    }

    private CompletionStage<byte[]> callByHeader(byte[] request) {
        long number = numbers.incrementAndGet();
        var reply = new CompletableFuture<byte[]>();
        byNumber.put(number, reply);
        byNumber.remove(number - MOST_WAITING); // which nobody has answered
        byte[] header = ByteBuffer.allocate(ServiceIdentity.BEGIN + ServiceIdentity.HEADER)
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(0)
                .putLong(id)
                .putLong(number)
                .array();
        participant.write(requests, date.getAsLong(), ServiceIdentity.with(header, request));
        return reply;
    }

    private CompletionStage<byte[]> callByIdentity(byte[] request) {
        Guid here = reader().data().guid();
        Consumer<ParameterList.Writer> beside = list -> ServiceIdentity.put(list, here, UNKNOWN);
        long number = participant
                .write(requests, date.getAsLong(), Optional.of(beside), request)
                .orElseThrow(); // a client's writer keeps the last ones, and never waits
        bySample.remove(number - MOST_WAITING); // which nobody has answered
        return reply(number).whenComplete((_, _) -> bySample.remove(number));
    }

    /// Of the request that has, or will have, this number: its reply may be here first.
    private CompletableFuture<byte[]> reply(long number) {
        return bySample.computeIfAbsent(number, _ -> new CompletableFuture<>());
    }

    /// A reply to one of our requests, or to somebody else's.
    void take(Sample sample) {
        Optional<ByteBuffer> identity = ServiceIdentity.in(sample.inlineQos());
        var payload = new byte[sample.payload().remaining()];
        sample.payload().get(payload);
        if (identity.isPresent()) {
            takeByIdentity(identity.get(), payload);
        } else if (payload.length >= ServiceIdentity.BEGIN + ServiceIdentity.HEADER) {
            takeByHeader(payload);
        }
    }

    private void takeByIdentity(ByteBuffer identity, byte[] payload) {
        Guid asked = Guid.read(identity);
        boolean isOurs = asked.equals(requests.data().guid())
                || asked.equals(reader().data().guid());
        long number = ((long) identity.getInt() << 32) | Integer.toUnsignedLong(identity.getInt());
        if (bySample.size() >= MOST_WAITING) {
            bySample.values().removeIf(CompletableFuture::isDone); // replies that came twice
        }
        if (isOurs && bySample.size() < MOST_WAITING) {
            reply(number).complete(payload);
        }
    }

    private void takeByHeader(byte[] payload) {
        boolean isLittle = payload[1] == 1;
        ByteBuffer bytes = ByteBuffer.wrap(payload).order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        if (bytes.getLong(ServiceIdentity.BEGIN) == id) {
            CompletableFuture<byte[]> reply = byNumber.remove(bytes.getLong(ServiceIdentity.BEGIN + Long.BYTES));
            if (reply != null) {
                reply.complete(ServiceIdentity.without(payload));
            }
        }
    }
}
