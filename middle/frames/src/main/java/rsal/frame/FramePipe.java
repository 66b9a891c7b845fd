package rsal.frame;

import java.io.ByteArrayOutputStream;
import java.io.EOFException;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Map;
import tools.jackson.core.JacksonException;
import tools.jackson.core.ObjectWriteContext;
import tools.jackson.core.json.JsonFactory;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.core.json.JsonWriteFeature;
import tools.jackson.databind.json.JsonMapper;

/// Frames between two processes, over pipes. A frame is the length of what follows its head, the length of its words,
/// the
/// words as a JSON object, and arrays as little-endian bytes. The lengths are little-endian 32-bit integers. Where a
/// value is an array, the words say which bytes it has: `{"array":"f4","at":0,"count":180}`.
///
/// Of one thread at a time.
public final class FramePipe {
    public static final int VERSION = 1;
    private static final int LONGEST = 1 << 26; // B
    private static final int HEAD = 8; // B
    private static final JsonFactory FACTORY =
            JsonFactory.builder().disable(JsonWriteFeature.WRITE_NAN_AS_STRINGS).build();
    private static final JsonMapper MAPPER = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();

    private final InputStream in;
    private final OutputStream out;
    private final Buffer words = new Buffer();
    private final Buffer arrays = new Buffer();
    private final byte[] head = new byte[HEAD];
    private final ByteBuffer lengths = ByteBuffer.wrap(head).order(ByteOrder.LITTLE_ENDIAN);
    private byte[] frame = new byte[1 << 12]; // that is written
    private byte[] body = new byte[1 << 12]; // of the one that was read

    /// @param out without a buffer
    public FramePipe(InputStream in, OutputStream out) {
        this.in = in;
        this.out = out;
    }

    /// What writes the words of a frame.
    @FunctionalInterface
    public interface Content {
        void write(ToWords to);
    }

    private static final class Buffer extends ByteArrayOutputStream {
        void copyTo(byte[] target, int at) {
            System.arraycopy(buf, 0, target, at, count);
        }
    }

    /// A frame that is too long was not sent.
    public static final class TooLong extends IOException {
        private static final long serialVersionUID = 1;

        private TooLong(String message) {
            super(message);
        }
    }

    /// @throws TooLong when it is longer than 64 MB; then nothing was written
    public void write(Content content) throws IOException {
        words.reset();
        arrays.reset();
        try (var generator = FACTORY.createGenerator(ObjectWriteContext.empty(), words)) {
            var to = new ToWords(generator, arrays);
            generator.writeStartObject();
            content.write(to);
            generator.writeEndObject();
        }
        int length = words.size() + arrays.size();
        if (length > LONGEST) {
            throw new TooLong("A frame has %d bytes; at most %d can be sent.".formatted(length, LONGEST));
        }
        frame = frame.length < HEAD + length ? new byte[2 * (HEAD + length)] : frame;
        lengths.putInt(0, length).putInt(Integer.BYTES, words.size());
        System.arraycopy(head, 0, frame, 0, HEAD);
        words.copyTo(frame, HEAD);
        arrays.copyTo(frame, HEAD + words.size());
        out.write(frame, 0, HEAD + length);
        out.flush();
    }

    /// A frame that was read.
    ///
    /// @param arrays little-endian; empty without any. Valid until the next frame is read
    public record Frame(Map<?, ?> words, ByteBuffer arrays) {}

    /// The words of the next frame.
    ///
    /// @throws EOFException when the other side has ended
    public Map<?, ?> read() throws IOException {
        return readFrame().words();
    }

    /// The next frame.
    ///
    /// @throws EOFException when the other side has ended
    public Frame readFrame() throws IOException {
        fill(head, HEAD);
        int length = lengths.getInt(0);
        int text = lengths.getInt(Integer.BYTES);
        if (text < 0 || length < text || length > LONGEST) {
            throw new IOException("A frame can't have %d bytes with %d of words.".formatted(length, text));
        }
        body = body.length < length ? new byte[2 * length] : body;
        fill(body, length);
        return new Frame(
                words(text), ByteBuffer.wrap(body, text, length - text).slice().order(ByteOrder.LITTLE_ENDIAN));
    }

    private Map<?, ?> words(int length) throws IOException {
        try {
            return MAPPER.readValue(body, 0, length, Map.class);
        } catch (JacksonException e) {
            throw new IOException("The words of a frame are not a JSON object.", e);
        }
    }

    private void fill(byte[] target, int count) throws IOException {
        if (in.readNBytes(target, 0, count) < count) {
            throw new EOFException("The other side has ended.");
        }
    }
}
