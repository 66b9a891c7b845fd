package rsal.mcap;

import com.github.luben.zstd.Zstd;
import com.github.luben.zstd.ZstdCompressCtx;
import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.WritableByteChannel;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.LongSupplier;
import java.util.zip.CRC32;

/// Writes a file as messages come: into chunks, which are compressed (zstd), checked (CRC-32) and written whole.
/// Whatever ends the process, what was written before stays readable; the chunk that is open is lost.
///
/// Keeps one chunk in memory, and for each that is written about 100 B for the index at the end. A message allocates
/// nothing. For one thread. After an [IOException] nothing more can be written.
public final class McapWriter implements Closeable {
    /// Larger than this and a chunk is written [B].
    static final int CHUNK = 1 << 20;

    /// Older than this and a chunk is written, in ns.
    static final long CHUNK_AGE = 1_000_000_000;

    private static final int LEVEL = 3; // zstd's usual one
    private static final String ZSTD = "zstd";
    private static final int MOST = 0xffff; // of schemas, and of channels: ids have two bytes

    private final WritableByteChannel out;
    private final LongSupplier clock;
    private final ZstdCompressCtx zstd = new ZstdCompressCtx().setLevel(LEVEL);
    private final CRC32 dataCrc = new CRC32();
    private final CRC32 crc = new CRC32();
    private final ByteSink record = new ByteSink(1 << 16); // scratch
    private final List<Schema> schemas = new ArrayList<>();
    private final List<Written> channels = new ArrayList<>();
    private final List<Written> used = new ArrayList<>(); // in the open chunk, in the order of their first message
    private long position; // in the file
    private boolean broken;
    private boolean closed;

    // the open chunk
    private final ByteSink chunk = new ByteSink(CHUNK + (CHUNK >> 2));
    private byte[] compressed = new byte[0];
    private long opened; // by the clock [ns]
    private long chunkStart;
    private long chunkEnd;

    // for the summary
    private final ByteSink chunkIndexes = new ByteSink(1 << 12);
    private final ByteSink attachmentIndexes = new ByteSink(1 << 8);
    private final ByteSink metadataIndexes = new ByteSink(1 << 8);
    private long messages;
    private int chunks;
    private int attachments;
    private int metadata;
    private long start;
    private long end;

    /// A channel, and where its messages are in the open chunk.
    private static final class Written {
        private final Channel channel;
        private long[] index = new long[32]; // time, offset, time, …
        private int indexed; // messages
        private long count; // in the file

        Written(Channel channel) {
            this.channel = channel;
        }

        void add(long time, long offset) {
            if (2 * indexed == index.length) {
                index = Arrays.copyOf(index, 2 * index.length);
            }
            index[2 * indexed] = time;
            index[2 * indexed + 1] = offset;
            indexed++;
            count++;
        }
    }

    /// Begins a file.
    ///
    /// @param out closed at the end
    /// @param library that writes, for people
    /// @param clock real time, by which chunks grow old, in ns
    public McapWriter(WritableByteChannel out, String library, LongSupplier clock) throws IOException {
        this(out, "", library, clock);
    }

    /// @param profile which rules channels and schemas follow (`ros2`); empty for none
    public McapWriter(WritableByteChannel out, String profile, String library, LongSupplier clock) throws IOException {
        this.out = out;
        this.clock = clock;
        write(ByteBuffer.wrap(Opcode.magic()));
        write(begin(Opcode.HEADER).string(profile).string(library));
    }

    /// Tells what messages look like.
    ///
    /// @return its id
    public int schema(String name, String encoding, byte[] data) throws IOException {
        checkRoom(schemas.size(), "kinds of messages");
        var schema = new Schema(schemas.size() + 1, name, encoding, data);
        schemas.add(schema);
        write(put(begin(Opcode.SCHEMA), schema));
        return schema.id();
    }

    /// A new channel. What it is stands in the file at once, before its messages, whatever becomes of those.
    ///
    /// @param schema as [#schema] returned it; 0 for none
    /// @return its id
    public int channel(int schema, String topic, String encoding, Map<String, String> metadata) throws IOException {
        checkRoom(channels.size(), "channels");
        var channel = new Channel(channels.size() + 1, schema, topic, encoding, metadata);
        channels.add(new Written(channel));
        write(put(begin(Opcode.CHANNEL), channel));
        return channel.id();
    }

    /// How much of the file there is [B], without the chunk that is open.
    public long size() {
        return position;
    }

    private static void checkRoom(int count, String what) {
        if (count == MOST) {
            throw new IllegalStateException("A file has at most %d %s.".formatted(MOST, what));
        }
    }

    /// @param channel as [#channel] returned it
    /// @param logTime by which messages are found, in ns
    /// @param publishTime when it was true, in ns
    public void message(int channel, long logTime, long publishTime, ByteBuffer data) throws IOException {
        Written written = channels.get(channel - 1);
        if (chunk.size() == 0) {
            opened = clock.getAsLong();
            chunkStart = logTime;
            chunkEnd = logTime;
        }
        if (written.indexed == 0) {
            used.add(written);
        }
        written.add(logTime, chunk.size());
        chunkStart = Math.min(chunkStart, logTime);
        chunkEnd = Math.max(chunkEnd, logTime);
        chunk.u8(Opcode.MESSAGE)
                .u64(Opcode.MESSAGE_HEAD + (long) data.remaining())
                .u16(channel)
                .u32((int) written.count)
                .u64(logTime)
                .u64(publishTime)
                .raw(data);
        if (chunk.size() >= CHUNK) {
            flush();
        }
    }

    /// Writes the open chunk if it is old. To be called now and then, also when no messages come.
    public void tick() throws IOException {
        if (chunk.size() > 0 && clock.getAsLong() - opened >= CHUNK_AGE) {
            flush();
        }
    }

    /// Writes the open chunk.
    public void flush() throws IOException {
        if (chunk.size() == 0) {
            return;
        }
        int length = compress();
        crc.reset();
        crc.update(chunk.array(), 0, chunk.size());
        long at = position;
        record.clear();
        record.u8(Opcode.CHUNK)
                .u64(8 + 8 + 8 + 4 + 4 + ZSTD.length() + 8 + (long) length)
                .u64(chunkStart)
                .u64(chunkEnd)
                .u64(chunk.size())
                .u32((int) crc.getValue())
                .string(ZSTD)
                .u64(length);
        write(record.written());
        write(ByteBuffer.wrap(compressed, 0, length));
        index(at, position - at, length);
        start = chunks == 0 ? chunkStart : Math.min(start, chunkStart);
        end = chunks == 0 ? chunkEnd : Math.max(end, chunkEnd);
        chunks++;
        used.forEach(written -> {
            messages += written.indexed;
            written.indexed = 0;
        });
        used.clear();
        chunk.clear();
    }

    private int compress() {
        int most = (int) Zstd.compressBound(chunk.size());
        if (compressed.length < most) {
            compressed = new byte[most];
        }
        return zstd.compressByteArray(compressed, 0, compressed.length, chunk.array(), 0, chunk.size());
    }

    /// Writes where the messages of a chunk are, and keeps where that is.
    private void index(long at, long length, int compressedLength) throws IOException {
        long indexStart = position;
        int from = beginIn(chunkIndexes, Opcode.CHUNK_INDEX);
        chunkIndexes.u64(chunkStart).u64(chunkEnd).u64(at).u64(length);
        chunkIndexes.u32(used.size() * (2 + 8));
        for (Written written : used) {
            chunkIndexes.u16(written.channel.id()).u64(position);
            begin(Opcode.MESSAGE_INDEX).u16(written.channel.id()).u32(written.indexed * 16);
            for (int i = 0; i < 2 * written.indexed; i++) {
                record.u64(written.index[i]);
            }
            write(record);
        }
        chunkIndexes
                .u64(position - indexStart)
                .string(ZSTD)
                .u64(compressedLength)
                .u64(chunk.size());
        endIn(chunkIndexes, from);
    }

    /// Writes something about the whole file.
    public void metadata(Metadata about) throws IOException {
        flush(); // in the order in which it came
        long at = position;
        write(begin(Opcode.METADATA).string(about.name()).map(about.entries()));
        int from = beginIn(metadataIndexes, Opcode.METADATA_INDEX);
        metadataIndexes.u64(at).u64(position - at).string(about.name());
        endIn(metadataIndexes, from);
        metadata++;
    }

    /// Writes a file into the file.
    public void attachment(Attachment file) throws IOException {
        flush(); // in the order in which it came
        long at = position;
        begin(Opcode.ATTACHMENT)
                .u64(file.logTime())
                .u64(file.createTime())
                .string(file.name())
                .string(file.mediaType())
                .u64(file.data().length)
                .raw(file.data());
        crc.reset();
        crc.update(record.array(), Opcode.PREFIX, record.size() - Opcode.PREFIX);
        write(record.u32((int) crc.getValue()));
        int from = beginIn(attachmentIndexes, Opcode.ATTACHMENT_INDEX);
        attachmentIndexes
                .u64(at)
                .u64(position - at)
                .u64(file.logTime())
                .u64(file.createTime())
                .u64(file.data().length)
                .string(file.name())
                .string(file.mediaType());
        endIn(attachmentIndexes, from);
        attachments++;
    }

    /// Writes what is left and the index, and closes the file; only closes it when writing has failed before. Closing
    /// twice does nothing.
    @Override
    public void close() throws IOException {
        if (closed) {
            return;
        }
        closed = true;
        try (out;
                zstd) {
            if (!broken) {
                flush();
                write(begin(Opcode.DATA_END).u32((int) dataCrc.getValue()));
                summary();
                write(ByteBuffer.wrap(Opcode.magic()));
            }
        }
    }

    private void summary() throws IOException {
        var summary = new ByteSink(chunkIndexes.size() + (1 << 16));
        var offsets = new ByteSink(1 << 8);
        long summaryStart = position;
        group(
                summary,
                offsets,
                Opcode.SCHEMA,
                () -> schemas.forEach(schema -> {
                    int from = beginIn(summary, Opcode.SCHEMA);
                    put(summary, schema);
                    endIn(summary, from);
                }));
        group(
                summary,
                offsets,
                Opcode.CHANNEL,
                () -> channels.forEach(written -> {
                    int from = beginIn(summary, Opcode.CHANNEL);
                    put(summary, written.channel);
                    endIn(summary, from);
                }));
        group(summary, offsets, Opcode.STATISTICS, () -> statistics(summary));
        group(summary, offsets, Opcode.CHUNK_INDEX, () -> summary.raw(chunkIndexes.written()));
        group(summary, offsets, Opcode.ATTACHMENT_INDEX, () -> summary.raw(attachmentIndexes.written()));
        group(summary, offsets, Opcode.METADATA_INDEX, () -> summary.raw(metadataIndexes.written()));
        long offsetStart = summaryStart + summary.size();
        summary.raw(offsets.written());
        summary.u8(Opcode.FOOTER).u64(Opcode.FOOTER_LENGTH).u64(summaryStart).u64(offsetStart);
        crc.reset();
        crc.update(summary.array(), 0, summary.size());
        summary.u32((int) crc.getValue());
        write(summary.written());
    }

    /// Puts records of one kind into the summary, and where they are into the offsets.
    private void group(ByteSink summary, ByteSink offsets, int opcode, Runnable records) {
        int from = summary.size();
        records.run();
        if (summary.size() > from) {
            int record = beginIn(offsets, Opcode.SUMMARY_OFFSET);
            offsets.u8(opcode).u64(position + from).u64(summary.size() - from);
            endIn(offsets, record);
        }
    }

    private void statistics(ByteSink summary) {
        int from = beginIn(summary, Opcode.STATISTICS);
        summary.u64(messages)
                .u16(schemas.size())
                .u32(channels.size())
                .u32(attachments)
                .u32(metadata)
                .u32(chunks)
                .u64(start)
                .u64(end);
        long heard = channels.stream().filter(written -> written.count > 0).count();
        summary.u32((int) heard * (2 + 8));
        channels.stream()
                .filter(written -> written.count > 0)
                .forEach(written -> summary.u16(written.channel.id()).u64(written.count));
        endIn(summary, from);
    }

    private static ByteSink put(ByteSink sink, Schema schema) {
        return sink.u16(schema.id())
                .string(schema.name())
                .string(schema.encoding())
                .u32(schema.data().length)
                .raw(schema.data());
    }

    private static ByteSink put(ByteSink sink, Channel channel) {
        return sink.u16(channel.id())
                .u16(channel.schema())
                .string(channel.topic())
                .string(channel.encoding())
                .map(channel.metadata());
    }

    /// A record in the scratch buffer; its length is filled in when it is written.
    private ByteSink begin(int opcode) {
        record.clear();
        beginIn(record, opcode);
        return record;
    }

    private static int beginIn(ByteSink sink, int opcode) {
        int from = sink.size();
        sink.u8(opcode).u64(0);
        return from;
    }

    private static void endIn(ByteSink sink, int from) {
        sink.u64At(from + 1, sink.size() - from - Opcode.PREFIX);
    }

    private void write(ByteSink begun) throws IOException {
        endIn(begun, 0);
        write(begun.written());
    }

    private void write(ByteBuffer bytes) throws IOException {
        if (broken) {
            throw new IOException("Writing has failed before.");
        }
        position += bytes.remaining();
        dataCrc.update(bytes.duplicate());
        try {
            while (bytes.hasRemaining()) {
                out.write(bytes);
            }
        } catch (IOException | RuntimeException e) {
            broken = true;
            throw e;
        }
    }
}
