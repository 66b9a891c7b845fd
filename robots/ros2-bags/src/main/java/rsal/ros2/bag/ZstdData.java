package rsal.ros2.bag;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdException;
import com.github.luben.zstd.ZstdIOException;
import com.github.luben.zstd.ZstdInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.file.Files;
import java.nio.file.Path;
import rsal.navigation.log.BrokenLog;

/// What rosbag2 compresses by Zstd: single messages (`compression_mode: message`), or a file as a whole
/// (`compression_mode: file`).
final class ZstdData {
    private static final int MAGIC = 0xFD2FB528; // no message of CDR begins so: its first byte is 0
    private static final int MOST_MESSAGE = 64 << 20; // B
    private static final long MOST_RATIO = 1_000; // bags have up to 30
    private static final long SMALL = 64L << 20; // B; files up to here may be made of any size
    private static final int BLOCK = 1 << 16; // B

    private ZstdData() {}

    /// A message that can't be decompressed.
    static final class DamagedMessage extends Exception {
        private static final long serialVersionUID = 1;

        DamagedMessage(String message) {
            super(message);
        }
    }

    /// A message as it was before it was compressed, if it was.
    ///
    /// @throws DamagedMessage when it is damaged, or too large
    static ByteBuffer message(ByteBuffer data) throws DamagedMessage {
        boolean isCompressed = data.remaining() >= Integer.BYTES
                && data.duplicate().order(ByteOrder.LITTLE_ENDIAN).getInt() == MAGIC;
        if (!isCompressed) {
            return data;
        }
        var compressed = new byte[data.remaining()];
        data.duplicate().get(compressed);
        long size = Zstd.getFrameContentSize(compressed);
        if (size < 0 || size > MOST_MESSAGE) {
            throw new DamagedMessage(
                    size < 0
                            ? "A compressed message does not say how many bytes it has."
                            : "A compressed message says that it has %d bytes; at most %d are read."
                                    .formatted(size, MOST_MESSAGE));
        }
        try {
            return ByteBuffer.wrap(Zstd.decompress(compressed, (int) size));
        } catch (ZstdException e) {
            throw new DamagedMessage("A compressed message is damaged: %s.".formatted(e.getMessage()));
        }
    }

    /// Decompresses a file.
    ///
    /// @param name of the file, for messages
    /// @param length of the compressed file [B]
    /// @throws BrokenLog when it is damaged, or much larger than bags are
    static void decompress(String name, InputStream in, long length, Path into) throws IOException {
        long most = Math.max(SMALL, MOST_RATIO * length);
        var block = new byte[BLOCK];
        long made = 0;
        try (var zstd = new ZstdInputStream(in);
                OutputStream out = Files.newOutputStream(into)) {
            for (int read = zstd.read(block); read >= 0; read = zstd.read(block)) {
                made += read;
                if (made > most) {
                    throw new BrokenLog(
                            name,
                            0,
                            "It has more than %d bytes when it is decompressed, which no bag has.".formatted(most));
                }
                out.write(block, 0, read);
            }
        } catch (ZstdIOException e) {
            throw new BrokenLog(name, 0, "It can't be decompressed: %s.".formatted(e.getMessage()), e);
        }
    }
}
