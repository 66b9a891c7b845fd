package rsal.player.wire;

import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.util.Optional;

/// A message with its body as it goes over the wire.
///
/// @param body shared, not to be changed
public record Packet(Header header, byte[] body) {
    private static final byte[] NOTHING = {};

    /// A message without a body.
    public static Packet of(Address address, MessageKind kind, int subtype, double time) {
        return new Packet(new Header(address, kind, subtype, time, 0, 0), NOTHING);
    }

    public static <T extends Record> Packet of(Address address, MessageKind kind, int subtype, double time, T body) {
        byte[] bytes = Layout.of(body).bytes(body);
        return new Packet(new Header(address, kind, subtype, time, 0, bytes.length), bytes);
    }

    /// The same as one of a sequence.
    public Packet withSequence(int sequence) {
        var numbered =
                new Header(header.address(), header.kind(), header.subtype(), header.time(), sequence, header.size());
        return new Packet(numbered, body);
    }

    /// The next of a stream; empty at its end.
    ///
    /// @throws MalformedException when what comes is none; the stream is of no more use then
    /// @throws EOFException when it ends within one
    public static Optional<Packet> read(InputStream from) throws IOException {
        return read(from, Header.MOST);
    }

    /// The same where no body has more bytes than that.
    public static Optional<Packet> read(InputStream from, int most) throws IOException {
        byte[] head = from.readNBytes(Header.BYTES);
        if (head.length == 0) {
            return Optional.empty();
        }
        checkLength(head, Header.BYTES);
        Header header = Header.read(ByteBuffer.wrap(head));
        if (header.size() > most) {
            throw new MalformedException(
                    "A message of %d bytes is too large; at most %d.".formatted(header.size(), most));
        }
        byte[] body = from.readNBytes(header.size());
        checkLength(body, header.size());
        return Optional.of(new Packet(header, body));
    }

    private static void checkLength(byte[] bytes, int expected) throws IOException {
        if (bytes.length < expected) {
            throw new EOFException("A message ends after %d of %d bytes.".formatted(bytes.length, expected));
        }
    }

    public byte[] bytes() {
        var bytes = ByteBuffer.allocate(Header.BYTES + body.length);
        header.write(bytes);
        return bytes.put(body).array();
    }

    /// The same with another body.
    public <T extends Record> Packet with(T other) {
        return of(header.address(), header.kind(), header.subtype(), header.time(), other)
                .withSequence(header.sequence());
    }

    public <T extends Record> T body(Class<T> type) throws MalformedException {
        return Layout.of(type).read(body);
    }

    /// What its body begins with; whatever stands behind that is left.
    public <T extends Record> T start(Class<T> type) throws MalformedException {
        return Layout.of(type).readStart(body);
    }
}
