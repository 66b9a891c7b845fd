package rsal.rtps.wire;

import java.nio.BufferOverflowException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.stream.Stream;

/// Values by number, as discovery and inline QoS send them (DDSI-RTPS 2.5, 9.4.2.11).
public final class ParameterList {
    public static final ParameterList EMPTY = new ParameterList(List.of());

    private static final int SENTINEL = 1;
    private static final int PAD = 0;
    private static final int MOST = 1_000; // parameters; peers send about 40

    private final List<Parameter> parameters;

    private record Parameter(int id, ByteBuffer value) {}

    private ParameterList(List<Parameter> parameters) {
        this.parameters = parameters;
    }

    /// Reads up to the sentinel, behind which the buffer then is.
    ///
    /// @param bytes in their byte order; the values are parts of them, not copied
    public static ParameterList read(ByteBuffer bytes) throws InvalidRtps {
        var parameters = new ArrayList<Parameter>();
        while (true) {
            if (bytes.remaining() < 4) {
                throw new InvalidRtps("A parameter list has no end.");
            }
            int id = bytes.getShort() & 0xffff;
            int length = bytes.getShort() & 0xffff;
            if (id == SENTINEL) {
                return new ParameterList(parameters);
            }
            if (length % 4 != 0 || length > bytes.remaining() || parameters.size() >= MOST) {
                throw new InvalidRtps("Parameter 0x%04x has %d bytes, of which %d are there."
                        .formatted(id, length, bytes.remaining()));
            }
            if (id != PAD) {
                parameters.add(
                        new Parameter(id, bytes.slice(bytes.position(), length).order(bytes.order())));
            }
            bytes.position(bytes.position() + length);
        }
    }

    /// The bytes of the first one of that number, if they are as many.
    public Optional<ByteBuffer> find(int id, int leastBytes) {
        return all(id, leastBytes).findFirst();
    }

    public Stream<ByteBuffer> all(int id, int leastBytes) {
        return parameters.stream()
                .filter(each -> each.id == id && each.value.limit() >= leastBytes)
                .map(each -> each.value.duplicate().order(each.value.order()));
    }

    /// Empty where it is not there, or no text.
    public Optional<String> text(int id) {
        return find(id, 4).flatMap(ParameterList::text);
    }

    private static Optional<String> text(ByteBuffer value) {
        int length = value.getInt();
        if (length < 0 || length > value.remaining()) {
            return Optional.empty();
        }
        var bytes = new byte[length];
        value.get(bytes);
        int end = length > 0 && bytes[length - 1] == 0 ? length - 1 : length;
        return Optional.of(new String(bytes, 0, end, StandardCharsets.UTF_8));
    }

    /// Octets with their count, such as user data, as text.
    public Optional<String> octets(int id) {
        return text(id);
    }

    /// With values of its own, which stay when the message is gone.
    public ParameterList copy() {
        return new ParameterList(parameters.stream()
                .map(each -> {
                    var value = ByteBuffer.allocate(each.value.limit()).order(each.value.order());
                    value.put(each.value.duplicate()).flip();
                    return new Parameter(each.id, value);
                })
                .toList());
    }

    public boolean isEmpty() {
        return parameters.isEmpty();
    }

    /// Writes parameters one after the other, little endian.
    public static final class Writer {
        private final ByteBuffer bytes;

        /// @throws IllegalArgumentException unless the buffer is little endian
        public Writer(ByteBuffer bytes) {
            if (bytes.order() != ByteOrder.LITTLE_ENDIAN) {
                throw new IllegalArgumentException("Parameter lists are written little endian.");
            }
            this.bytes = bytes;
        }

        /// @param value writes it
        /// @throws BufferOverflowException when it does not fit
        public Writer put(int id, Consumer<ByteBuffer> value) {
            int start = bytes.position();
            bytes.putShort((short) id).putShort((short) 0);
            value.accept(bytes);
            while ((bytes.position() - start) % 4 != 0) {
                bytes.put((byte) 0);
            }
            bytes.putShort(start + 2, (short) (bytes.position() - start - 4));
            return this;
        }

        public Writer putInt(int id, int value) {
            return put(id, to -> to.putInt(value));
        }

        public Writer putText(int id, String text) {
            return put(id, to -> {
                byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
                to.putInt(utf8.length + 1).put(utf8).put((byte) 0);
            });
        }

        public Writer putOctets(int id, String text) {
            return put(id, to -> {
                byte[] utf8 = text.getBytes(StandardCharsets.UTF_8);
                to.putInt(utf8.length).put(utf8);
            });
        }

        /// @return how many bytes there are in the buffer, with these
        public int end() {
            bytes.putShort((short) SENTINEL).putShort((short) 0);
            return bytes.position();
        }
    }
}
