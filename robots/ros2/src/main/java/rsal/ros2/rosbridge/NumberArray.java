package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/// The numbers of a typed array of CBOR (RFC 8746). Its tag is 0b010_f_s_e_ll: floating point, signed, little
/// endian, and the size.
final class NumberArray {
    static final int UINT8 = 64;
    static final int FLOAT32 = 85; // little endian, as all that rosbridge sends

    private static final int FIRST = 64;
    private static final int LAST = 87;
    private static final int FLOAT = 0b1_0000;
    private static final int SIGNED = 0b1000;
    private static final int LITTLE_ENDIAN = 0b100;
    private static final int SIZE = 0b11;

    private final ByteBuffer bytes;
    private final boolean isFloat;
    private final boolean isSigned;
    private final int size; // bytes of one

    private NumberArray(ByteBuffer bytes, boolean isFloat, boolean isSigned, int size) {
        this.bytes = bytes;
        this.isFloat = isFloat;
        this.isSigned = isSigned;
        this.size = size;
    }

    /// Whether a tag of CBOR says that it is one.
    static boolean isTag(long tag) {
        return tag >= FIRST && tag <= LAST;
    }

    static NumberArray of(WireValue.Numbers value) throws InvalidMessage {
        int tag = value.tag();
        boolean isFloat = (tag & FLOAT) != 0;
        int size = (isFloat ? 2 : 1) << (tag & SIZE);
        if (!isTag(tag) || (isFloat && (tag & SIGNED) != 0) || size > Double.BYTES) {
            throw new InvalidMessage("Arrays with tag %d are not supported.".formatted(tag));
        }
        if (value.bytes().remaining() % size != 0) {
            throw new InvalidMessage("%d bytes can't be numbers of %d bytes each."
                    .formatted(value.bytes().remaining(), size));
        }
        boolean isLittle = (tag & LITTLE_ENDIAN) != 0;
        ByteBuffer bytes = value.bytes().slice().order(isLittle ? ByteOrder.LITTLE_ENDIAN : ByteOrder.BIG_ENDIAN);
        return new NumberArray(bytes, isFloat, (tag & SIGNED) != 0, size);
    }

    int count() {
        return bytes.capacity() / size;
    }

    boolean isFloat() {
        return isFloat;
    }

    /// @return of an unsigned one of 64 bits the bits
    long integer(int i) {
        long value = switch (size) {
            case Byte.BYTES -> bytes.get(i);
            case Short.BYTES -> bytes.getShort(i * size);
            case Integer.BYTES -> bytes.getInt(i * size);
            default -> bytes.getLong(i * size);
        };
        return isSigned || size == Long.BYTES ? value : value & ((1L << (Byte.SIZE * size)) - 1);
    }

    double real(int i) {
        if (!isFloat) {
            return integer(i);
        }
        return switch (size) {
            case Short.BYTES -> Float.float16ToFloat(bytes.getShort(i * size));
            case Float.BYTES -> bytes.getFloat(i * size);
            default -> bytes.getDouble(i * size);
        };
    }
}
