package rsal.mcap;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.Arrays;
import java.util.BitSet;
import java.util.Optional;

/// Reads the index at the end of a file.
final class Summary {
    private static final int TAIL = Opcode.PREFIX + Opcode.FOOTER_LENGTH + 8; // [B]
    private static final int MOST_RECORD = 64 << 20; // [B]

    private final FileWindow window;
    private final long size;
    private final McapContents contents = new McapContents();
    private long messages = -1; // as it says; −1: it does not

    Summary(FileWindow window, long size) {
        this.window = window;
        this.size = size;
    }

    /// @return what it says; empty when there is none, or none that all messages can be found by
    /// @throws Malformed when it is damaged, or cut off
    Optional<McapContents> read() throws IOException, Malformed {
        byte[] magic = Opcode.magic();
        if (size < magic.length + TAIL) {
            throw new Malformed("there is none");
        }
        long footer = size - TAIL;
        ByteBuffer tail = window.at(footer, TAIL).order(ByteOrder.LITTLE_ENDIAN);
        byte[] last = new byte[magic.length];
        tail.get(TAIL - magic.length, last);
        if (!Arrays.equals(last, magic) || tail.get(0) != Opcode.FOOTER || tail.getLong(1) != Opcode.FOOTER_LENGTH) {
            throw new Malformed("the file does not end as it should");
        }
        long start = tail.getLong(Opcode.PREFIX);
        long offsets = tail.getLong(Opcode.PREFIX + 8);
        int expected = tail.getInt(Opcode.PREFIX + 16);
        if (start == 0) {
            return Optional.empty();
        }
        long end = offsets == 0 ? footer : offsets;
        if (start < magic.length || end < start || end > footer) {
            throw new Malformed("it is not where the file says");
        }
        if (expected != 0 && expected != window.crc(start, footer + Opcode.PREFIX + 16 - start)) {
            throw new Malformed("its checksum is not right");
        }
        header();
        for (long at = start; at < end; ) {
            at = record(at, end, start);
        }
        boolean isEnough = messages == 0 || (messages > 0 && !contents.blocks.isEmpty());
        return isEnough ? Optional.of(contents) : Optional.empty();
    }

    private void header() throws IOException, Malformed {
        RecordFields fields = whole(Opcode.magic().length, Opcode.HEADER, size);
        fields.string();
        contents.library = fields.string();
    }

    /// A record that is known to be of a kind.
    private RecordFields whole(long at, int opcode, long end) throws IOException, Malformed {
        if (at < 0 || at + Opcode.PREFIX > end) {
            throw new Malformed("a record is not where it says");
        }
        ByteBuffer head = window.at(at, Opcode.PREFIX).order(ByteOrder.LITTLE_ENDIAN);
        long length = head.getLong(1);
        if (Byte.toUnsignedInt(head.get(0)) != opcode
                || length < 0
                || length > MOST_RECORD
                || length > end - at - Opcode.PREFIX) {
            throw new Malformed("a record is not where it says");
        }
        return new RecordFields(window.at(at + Opcode.PREFIX, (int) length));
    }

    /// @return where the next begins
    private long record(long at, long end, long dataEnd) throws IOException, Malformed {
        if (at + Opcode.PREFIX > end) {
            throw new Malformed("it ends within a record");
        }
        int opcode = Byte.toUnsignedInt(window.at(at, 1).get(0));
        RecordFields fields = whole(at, opcode, end);
        long next = at + Opcode.PREFIX + fields.remaining();
        switch (opcode) {
            case Opcode.SCHEMA -> contents.schema(fields);
            case Opcode.CHANNEL -> contents.channel(fields);
            case Opcode.STATISTICS -> statistics(fields);
            case Opcode.CHUNK_INDEX -> chunk(fields, dataEnd);
            case Opcode.ATTACHMENT_INDEX -> attachment(fields, dataEnd);
            case Opcode.METADATA_INDEX -> contents.metadata(whole(fields.u64(), Opcode.METADATA, dataEnd));
            default -> {} // of no use here
        }
        return next;
    }

    private void statistics(RecordFields fields) throws Malformed {
        messages = fields.u64();
        fields.u16();
        for (int i = 0; i < 4; i++) {
            fields.u32();
        }
        fields.u64();
        fields.u64();
        RecordFields counts = fields.part();
        while (counts.remaining() > 0) {
            contents.counts.put(counts.u16(), counts.u64());
        }
    }

    private void chunk(RecordFields fields, long dataEnd) throws Malformed {
        long start = fields.u64();
        long end = fields.u64();
        long offset = fields.u64();
        long length = fields.u64();
        inFile(offset, length, dataEnd);
        RecordFields indexes = fields.part();
        var channels = new BitSet();
        while (indexes.remaining() > 0) {
            channels.set(indexes.u16());
            indexes.u64();
        }
        contents.blocks.add(new MessageBlock(offset, length, true, start, end, channels));
    }

    private void attachment(RecordFields fields, long dataEnd) throws Malformed {
        long offset = fields.u64();
        long length = fields.u64();
        inFile(offset, length, dataEnd);
        long logTime = fields.u64();
        fields.u64();
        long bytes = fields.u64();
        contents.attachments.add(new AttachmentEntry(fields.string(), fields.string(), logTime, offset, length, bytes));
    }

    private static void inFile(long offset, long length, long dataEnd) throws Malformed {
        if (offset < Opcode.magic().length || length < Opcode.PREFIX || length > dataEnd - offset) {
            throw new Malformed("it names a place that is not in the file");
        }
    }
}
