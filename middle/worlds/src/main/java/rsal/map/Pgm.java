package rsal.map;

/// Reads one portable gray map, plain (P2) or raw (P5, one or two bytes a pixel), as netpbm's manual describes them.
final class Pgm {
    private final String name;
    private final byte[] bytes;
    private int next;

    /// @param bytes begin with `P2` or `P5`
    Pgm(String name, byte[] bytes) {
        this.name = name;
        this.bytes = bytes;
        this.next = 2;
    }

    MapImage read(Shading shading) {
        boolean raw = bytes[1] == '5';
        int width = number();
        int height = number();
        MapImage.checkSize(name, width, height);
        int white = number();
        if (white < 1 || white > 65535) {
            throw MapImage.broken(name, "its brightest value is '%d', not 1 to 65535".formatted(white));
        }
        next++; // one blank ends the header
        int pixelBytes = white < 256 ? 1 : 2;
        if (raw && bytes.length - next < (long) width * height * pixelBytes) {
            throw MapImage.broken(name, "it ends early");
        }
        var cells = new MapImage.Cells(width, height, shading);
        for (int row = height - 1; row >= 0; row--) {
            for (int column = 0; column < width; column++) {
                int value = raw ? raw(pixelBytes) : number();
                if (value > white) {
                    throw MapImage.broken(name, "a pixel '%d' is brighter than white '%d'".formatted(value, white));
                }
                cells.set(column, row, (double) value / white);
            }
        }
        return cells.image();
    }

    private int raw(int pixelBytes) {
        int value = bytes[next++] & 0xff;
        return pixelBytes == 1 ? value : (value << 8) | (bytes[next++] & 0xff);
    }

    /// The next number in decimal digits, behind blanks and comments (`#` to the end of the line).
    private int number() {
        while (next < bytes.length && (isBlank(bytes[next]) || bytes[next] == '#')) {
            if (bytes[next] == '#') {
                while (next < bytes.length && bytes[next] != '\n' && bytes[next] != '\r') {
                    next++;
                }
            } else {
                next++;
            }
        }
        int start = next;
        int value = 0;
        while (next < bytes.length && bytes[next] >= '0' && bytes[next] <= '9') {
            value = value * 10 + bytes[next++] - '0';
            if (value > MapImage.MAX_CELLS) {
                throw MapImage.broken(name, "a number in it is too large");
            }
        }
        if (next == start) {
            throw MapImage.broken(name, next >= bytes.length ? "it ends early" : "a number is missing in it");
        }
        return value;
    }

    private static boolean isBlank(byte b) {
        return b == ' ' || (b >= '\t' && b <= '\r');
    }
}
