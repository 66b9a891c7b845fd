package rsal.image;

import java.util.BitSet;
import rsal.image.BitmapReader.Unreadable;

/// Reads one portable image: bits, gray or colors, plain (P1–P3) or raw (P4–P6), as netpbm's manual
/// describes them.
final class PortableImage {
    private final byte[] bytes;
    private final double threshold;
    private int next = 2;

    /// @param bytes begin with `P1` to `P6`
    PortableImage(byte[] bytes, double threshold) {
        this.bytes = bytes;
        this.threshold = threshold;
    }

    Bitmap read() throws Unreadable {
        int kind = bytes[1] - '0';
        boolean raw = kind > 3;
        boolean bits = kind == 1 || kind == 4;
        int channels = kind == 3 || kind == 6 ? 3 : 1;
        int width = number();
        int height = number();
        BitmapReader.checkSize(width, height);
        int brightest = bits ? 1 : number();
        if (brightest < 1 || brightest > 65535) {
            throw new Unreadable("its brightest value is '%d', not 1 to 65535".formatted(brightest));
        }
        if (raw) {
            next++; // one blank ends the header
        }
        var solid = new BitSet(width * height);
        for (int row = height - 1; row >= 0; row--) {
            if (bits) {
                bitRow(solid, row * width, width, raw);
            } else {
                for (int column = 0; column < width; column++) {
                    int first = sample(raw, brightest);
                    for (int i = 1; i < channels; i++) {
                        sample(raw, brightest);
                    }
                    solid.set(row * width + column, BitmapReader.isSolid(first, brightest, threshold));
                }
            }
        }
        return new Bitmap(width, height, solid);
    }

    /// 1 is black; raw rows begin with a byte of their own.
    private void bitRow(BitSet solid, int from, int width, boolean raw) throws Unreadable {
        int packed = 0;
        for (int column = 0; column < width; column++) {
            if (raw && column % 8 == 0) {
                packed = rawByte();
            }
            boolean black = raw ? (packed & 0x80 >> column % 8) != 0 : digit() == 1;
            solid.set(from + column, black);
        }
    }

    private int sample(boolean raw, int brightest) throws Unreadable {
        if (!raw) {
            return number();
        }
        return brightest < 256 ? rawByte() : rawByte() << 8 | rawByte();
    }

    private int rawByte() throws Unreadable {
        if (next >= bytes.length) {
            throw new Unreadable("it ends early");
        }
        return bytes[next++] & 0xff;
    }

    /// Plain bits need no blanks between them.
    private int digit() throws Unreadable {
        skipBlanks();
        int digit = rawByte() - '0';
        if (digit != 0 && digit != 1) {
            throw new Unreadable("a bit is neither 0 nor 1");
        }
        return digit;
    }

    private int number() throws Unreadable {
        skipBlanks();
        int start = next;
        int value = 0;
        while (next < bytes.length && bytes[next] >= '0' && bytes[next] <= '9') {
            value = value * 10 + bytes[next++] - '0';
            if (value > BitmapReader.MAX_PIXELS) {
                throw new Unreadable("it has a number that is too large");
            }
        }
        if (next == start) {
            throw new Unreadable(next < bytes.length ? "a number is missing in it" : "it ends early");
        }
        return value;
    }

    /// Comments run from `#` to the end of the line.
    private void skipBlanks() {
        boolean comment = false;
        while (next < bytes.length && (comment || bytes[next] <= ' ' || bytes[next] == '#')) {
            comment = bytes[next] != '\n' && bytes[next] != '\r' && (comment || bytes[next] == '#');
            next++;
        }
    }
}
