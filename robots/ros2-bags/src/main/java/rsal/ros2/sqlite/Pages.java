package rsal.ros2.sqlite;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;

/// The pages of a file, numbered from 1.
///
/// @param size of each [B], a power of two
/// @param usable of it, without what extensions reserve at its end [B]
/// @param count of whole pages
record Pages(FileChannel file, int size, int usable, long count) {
    /// Reads a page.
    ///
    /// @param into as large as a page
    void read(long number, ByteBuffer into) throws IOException {
        if (number < 1 || number > count) {
            throw new InvalidSqlite("Page %d is not there; there are %d".formatted(number, count));
        }
        into.clear().order(ByteOrder.BIG_ENDIAN);
        long at = (number - 1) * size;
        while (into.hasRemaining()) {
            if (file.read(into, at + into.position()) < 0) {
                throw new EOFException("The file has become shorter while it was read.");
            }
        }
        into.flip();
    }

    ByteBuffer room() {
        return ByteBuffer.allocate(size);
    }
}
