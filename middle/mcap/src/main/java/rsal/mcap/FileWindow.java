package rsal.mcap;

import java.io.EOFException;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.util.zip.CRC32;

/// Looks at a file through a buffer, so that small parts side by side are read at once.
final class FileWindow {
    private static final int SIZE = 1 << 16;

    private final FileChannel file;
    private ByteBuffer bytes = ByteBuffer.allocate(SIZE).limit(0);
    private long from; // where the buffer begins

    FileWindow(FileChannel file) {
        this.file = file;
    }

    /// Some bytes, valid until the next are asked for.
    ///
    /// @throws EOFException when there are fewer
    ByteBuffer at(long position, int length) throws IOException {
        boolean isThere = position >= from && position + length <= from + bytes.limit();
        if (!isThere) {
            fill(position, length);
        }
        return bytes.slice((int) (position - from), length);
    }

    private void fill(long position, int length) throws IOException {
        if (bytes.capacity() < length || bytes.capacity() > Math.max(SIZE, 4 * length)) {
            bytes = ByteBuffer.allocate(Math.max(SIZE, length));
        }
        from = position;
        bytes.clear();
        while (bytes.position() < length) {
            if (file.read(bytes, position + bytes.position()) < 0) {
                bytes.limit(0);
                throw new EOFException("The file has become shorter while it was read.");
            }
        }
        bytes.flip();
    }

    /// CRC-32 of a part of the file.
    int crc(long position, long length) throws IOException {
        var crc = new CRC32();
        for (long done = 0; done < length; done += SIZE) {
            crc.update(at(position + done, (int) Math.min(SIZE, length - done)));
        }
        return (int) crc.getValue();
    }
}
