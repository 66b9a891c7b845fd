package rsal.mcap;

import com.github.luben.zstd.ZstdDecompressCtx;
import com.github.luben.zstd.ZstdException;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.zip.CRC32;
import net.jpountz.lz4.LZ4Exception;
import net.jpountz.lz4.LZ4Factory;
import net.jpountz.lz4.LZ4FrameInputStream;
import net.jpountz.lz4.LZ4SafeDecompressor;
import net.jpountz.xxhash.XXHash32;
import net.jpountz.xxhash.XXHashFactory;

/// Gets the records out of blocks. For one thread.
final class Chunks implements AutoCloseable {
    /// Larger chunks are refused, whatever their length says [B].
    static final int MOST = 64 << 20;

    private static final int MOST_COMPRESSION = 100; // characters of its name

    // without native code and without sun.misc.Unsafe
    private static final LZ4SafeDecompressor LZ4 = LZ4Factory.safeInstance().safeDecompressor();
    private static final XXHash32 LZ4_SUM = XXHashFactory.safeInstance().hash32();

    private final FileWindow window;
    private final ZstdDecompressCtx zstd = new ZstdDecompressCtx();
    private final CRC32 crc = new CRC32();
    private byte[] compressed = new byte[0];
    private byte[] records = new byte[0];

    Chunks(FileWindow window) {
        this.window = window;
    }

    /// Its records, checked.
    ///
    /// @param own whether they are the caller's to keep; else they are valid until the next are read
    /// @throws Malformed with what is wrong with it
    ByteBuffer records(MessageBlock block, boolean own) throws IOException, Malformed {
        if (!block.isChunk()) {
            byte[] bytes = own ? new byte[(int) block.length()] : room((int) block.length());
            window.at(block.offset(), (int) block.length()).get(bytes, 0, (int) block.length());
            return little(bytes, (int) block.length());
        }
        return chunk(block.offset(), block.length(), own);
    }

    private ByteBuffer chunk(long offset, long length, boolean own) throws IOException, Malformed {
        int head = (int) Math.min(length, Opcode.PREFIX + 8 + 8 + 8 + 4 + 4 + MOST_COMPRESSION + 8);
        var fields = new RecordFields(window.at(offset, head));
        if (fields.u8() != Opcode.CHUNK || fields.u64() != length - Opcode.PREFIX) {
            throw new Malformed("there is no chunk of that length");
        }
        fields.u64();
        fields.u64();
        long size = fields.u64();
        int expected = fields.crc();
        String compression = fields.string();
        long compressedSize = fields.u64();
        long from = offset + head - fields.remaining();
        if (compressedSize < 0 || compressedSize > offset + length - from) {
            throw new Malformed("it says that it is longer than it is");
        }
        if (size < 0 || size > MOST || compressedSize > MOST + (1 << 20)) {
            throw new Malformed("it says that it has %s bytes; more than %d are not read"
                    .formatted(Long.toUnsignedString(Math.max(size, compressedSize)), MOST));
        }
        byte[] target = own ? new byte[(int) size] : room((int) size);
        switch (compression) {
            case "zstd" -> decompressZstd(from, (int) compressedSize, target, (int) size);
            case "lz4" -> decompressLz4(from, (int) compressedSize, target, (int) size);
            case "" -> {
                if (compressedSize != size) {
                    throw new Malformed("its two lengths are not the same");
                }
                window.at(from, (int) size).get(target, 0, (int) size);
            }
            default -> throw new Malformed("it is compressed by '%s', which is not read here".formatted(compression));
        }
        crc.reset();
        crc.update(target, 0, (int) size);
        if (expected != 0 && expected != (int) crc.getValue()) {
            throw new Malformed("its checksum is not right");
        }
        return little(target, (int) size);
    }

    private byte[] room(int size) {
        if (records.length < size) {
            records = new byte[size];
        }
        return records;
    }

    private void decompressZstd(long from, int length, byte[] target, int size) throws IOException, Malformed {
        fetch(from, length);
        try {
            checkSize(zstd.decompressByteArray(target, 0, size, compressed, 0, length), size);
        } catch (ZstdException e) {
            throw new Malformed("it can't be decompressed: " + e.getMessage());
        }
    }

    private void decompressLz4(long from, int length, byte[] target, int size) throws IOException, Malformed {
        fetch(from, length);
        try (var frames = new LZ4FrameInputStream(new ByteArrayInputStream(compressed, 0, length), LZ4, LZ4_SUM)) {
            checkSize(frames.readNBytes(target, 0, size) + frames.readNBytes(1).length, size);
        } catch (IOException | LZ4Exception e) {
            throw new Malformed("it can't be decompressed: " + e.getMessage());
        }
    }

    private void fetch(long from, int length) throws IOException {
        if (compressed.length < length) {
            compressed = new byte[length];
        }
        window.at(from, length).get(compressed, 0, length);
    }

    private static void checkSize(int made, int size) throws Malformed {
        if (made != size) {
            throw new Malformed("it has %d bytes, not %d".formatted(made, size));
        }
    }

    private static ByteBuffer little(byte[] bytes, int length) {
        return ByteBuffer.wrap(bytes, 0, length).order(ByteOrder.LITTLE_ENDIAN);
    }

    /// Where the next record begins.
    ///
    /// @throws Malformed when this one is longer than what is left
    static int after(ByteBuffer records, int at) throws Malformed {
        int left = records.limit() - at;
        long length = left < Opcode.PREFIX ? -1 : records.getLong(at + 1);
        if (length < 0 || length > left - Opcode.PREFIX) {
            throw new Malformed("a record in it is longer than what is left");
        }
        boolean isShort = records.get(at) == Opcode.MESSAGE && length < Opcode.MESSAGE_HEAD;
        if (isShort) {
            throw new Malformed("a message in it is too short");
        }
        return at + Opcode.PREFIX + (int) length;
    }

    /// What is in a record.
    static RecordFields content(ByteBuffer records, int at, int next) {
        return new RecordFields(records.slice(at + Opcode.PREFIX, next - at - Opcode.PREFIX));
    }

    @Override
    public void close() {
        zstd.close();
    }
}
