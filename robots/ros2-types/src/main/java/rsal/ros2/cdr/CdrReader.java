package rsal.ros2.cdr;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;

/// Reads a message from its bytes, value after value. Values are aligned to their sizes, counted from behind the
/// encapsulation header. Allocates only the arrays and texts that it returns. Of one thread.
public final class CdrReader {
    private static final int HEADER = 4; // bytes: which representation, and options
    private static final int BIG_ENDIAN = 0;
    private static final int LITTLE_ENDIAN = 1;
    private static final int COUNT = 4; // bytes of the length of a text or sequence

    private final ByteBuffer bytes;
    private final int origin;

    private CdrReader(ByteBuffer bytes, int origin) {
        this.bytes = bytes;
        this.origin = origin;
    }

    /// @param payload with its encapsulation header, from its position to its limit; not copied
    /// @throws InvalidCdr when it is in another representation than XCDR1, as no ROS 2 writes it
    public static CdrReader of(ByteBuffer payload) throws InvalidCdr {
        ByteBuffer bytes = payload.slice().order(ByteOrder.BIG_ENDIAN);
        if (bytes.remaining() < HEADER) {
            throw new InvalidCdr("A message of %d bytes has no header; it should have at least %d."
                    .formatted(bytes.remaining(), HEADER));
        }
        int representation = bytes.getShort(0) & 0xffff;
        if (representation != BIG_ENDIAN && representation != LITTLE_ENDIAN) {
            throw new InvalidCdr("Representation 0x%04x of a message is not supported; 0x0000 and 0x0001 are (XCDR1)."
                    .formatted(representation));
        }
        bytes.position(HEADER);
        return new CdrReader(
                bytes.order(representation == LITTLE_ENDIAN ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN), HEADER);
    }

    /// @param payload with its encapsulation header; not copied
    public static CdrReader of(byte[] payload) throws InvalidCdr {
        return of(ByteBuffer.wrap(payload));
    }

    /// Another reader of the same message that begins where this one is.
    public CdrReader copy() {
        return new CdrReader(bytes.duplicate().order(bytes.order()), origin);
    }

    /// Whether no value of this alignment can follow: nothing is left, or what some writers fill up with to a
    /// multiple of 4 bytes.
    public boolean isAtEnd(int alignment) {
        return begin(alignment) >= bytes.limit() - origin;
    }

    public boolean bool() throws InvalidCdr {
        return int8() != 0;
    }

    public byte int8() throws InvalidCdr {
        need(1, 1);
        return bytes.get();
    }

    public short int16() throws InvalidCdr {
        need(2, 2);
        return bytes.getShort();
    }

    public int int32() throws InvalidCdr {
        need(4, 4);
        return bytes.getInt();
    }

    public long int64() throws InvalidCdr {
        need(8, 8);
        return bytes.getLong();
    }

    public float float32() throws InvalidCdr {
        need(4, 4);
        return bytes.getFloat();
    }

    public double float64() throws InvalidCdr {
        need(8, 8);
        return bytes.getDouble();
    }

    /// A text of UTF-8. What is no UTF-8 becomes `�`.
    public String text() throws InvalidCdr {
        int length = textLength();
        var text = new byte[Math.max(0, length - 1)]; // a zero ends it
        bytes.get(text);
        if (length > 0) {
            bytes.get();
        }
        return new String(text, StandardCharsets.UTF_8);
    }

    /// The same; where it is the likely one, that object.
    ///
    /// @param likely of ASCII
    public String text(String likely) throws InvalidCdr {
        int begin = bytes.position();
        int length = textLength();
        if (length == likely.length() + 1 && isNext(likely)) {
            bytes.position(bytes.position() + length);
            return likely;
        }
        bytes.position(begin);
        return text();
    }

    private boolean isNext(String text) {
        int at = bytes.position();
        for (int i = 0; i < text.length(); i++) {
            if (bytes.get(at + i) != text.charAt(i)) {
                return false;
            }
        }
        return true;
    }

    private int textLength() throws InvalidCdr {
        int length = int32();
        if (length < 0 || length > bytes.remaining()) {
            throw tooMany("A text", Integer.toUnsignedLong(length));
        }
        return length;
    }

    /// The number of elements of a sequence.
    ///
    /// @param least bytes that an element takes at least, so that no memory is allocated for what cannot be there
    public int count(int least) throws InvalidCdr {
        int count = int32();
        if (count < 0 || count > bytes.remaining() / Math.max(1, least)) {
            throw tooMany("A sequence", Integer.toUnsignedLong(count));
        }
        return count;
    }

    private InvalidCdr tooMany(String what, long count) {
        return new InvalidCdr("%s at byte %d claims to have %d elements, but only %d bytes follow."
                .formatted(what, bytes.position() - origin - COUNT, count, bytes.remaining()));
    }

    public byte[] int8s(int count) throws InvalidCdr {
        need(1, count);
        var array = new byte[count];
        bytes.get(array);
        return array;
    }

    public short[] int16s(int count) throws InvalidCdr {
        ByteBuffer elements = elements(2, count);
        var array = new short[count];
        elements.asShortBuffer().get(array);
        return array;
    }

    public int[] int32s(int count) throws InvalidCdr {
        ByteBuffer elements = elements(4, count);
        var array = new int[count];
        elements.asIntBuffer().get(array);
        return array;
    }

    public long[] int64s(int count) throws InvalidCdr {
        ByteBuffer elements = elements(8, count);
        var array = new long[count];
        elements.asLongBuffer().get(array);
        return array;
    }

    public float[] float32s(int count) throws InvalidCdr {
        ByteBuffer elements = elements(4, count);
        var array = new float[count];
        elements.asFloatBuffer().get(array);
        return array;
    }

    public double[] float64s(int count) throws InvalidCdr {
        ByteBuffer elements = elements(8, count);
        var array = new double[count];
        elements.asDoubleBuffer().get(array);
        return array;
    }

    /// Leaves out so many elements of that size.
    public void skip(int size, int count) throws InvalidCdr {
        elements(size, count);
    }

    /// The bytes of so many elements, which count as read.
    private ByteBuffer elements(int size, int count) throws InvalidCdr {
        need(size, (long) size * count);
        int begin = bytes.position();
        bytes.position(begin + size * count);
        return bytes.slice(begin, size * count).order(bytes.order());
    }

    /// Goes to the next multiple of a size, unless nothing follows, as an empty array has no alignment.
    private void need(int alignment, long size) throws InvalidCdr {
        if (size == 0) {
            return;
        }
        int begin = begin(alignment);
        if (begin + size > bytes.limit() - origin) {
            throw new InvalidCdr("The message ends at byte %d, within a value of %d bytes at byte %d."
                    .formatted(bytes.limit() - origin, size, begin));
        }
        bytes.position(origin + begin);
    }

    /// Where the next value begins, counted from behind the header.
    private int begin(int alignment) {
        return (bytes.position() - origin + alignment - 1) & -alignment;
    }
}
