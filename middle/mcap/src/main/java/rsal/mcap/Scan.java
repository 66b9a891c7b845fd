package rsal.mcap;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.BitSet;

/// Reads a file from its beginning, record by record, as far as it goes: without its index, which one that was cut
/// off does not have.
final class Scan {
    private static final long MOST_RECORD = 64 << 20; // [B]
    private static final long MOST_LOOSE = 1 << 20; // [B] of messages outside of chunks that are read at once
    private static final int MOST_NOTES = 100;

    private final FileWindow window;
    private final Chunks chunks;
    private final long size;
    private final McapContents contents = new McapContents();
    private int notes;
    private int strays; // messages of no channel

    // messages outside of chunks
    private long looseAt;
    private long looseLength;
    private long looseStart;
    private long looseEnd;
    private BitSet looseChannels = new BitSet();

    Scan(FileWindow window, Chunks chunks, long size) {
        this.window = window;
        this.chunks = chunks;
        this.size = size;
    }

    /// @param withSum whether to check the sum of all data, too, for which all is read twice
    McapContents read(boolean withSum) throws IOException {
        long at = Opcode.magic().length;
        boolean ended = false;
        while (!ended && at + Opcode.PREFIX <= size) {
            ByteBuffer head = window.at(at, Opcode.PREFIX).order(ByteOrder.LITTLE_ENDIAN);
            int opcode = Byte.toUnsignedInt(head.get(0));
            long length = head.getLong(1);
            if (opcode == 0 || (opcode > Opcode.DATA_END && opcode < 0x80)) {
                break; // nothing that can be a record
            }
            if (length < 0 || length > size - at - Opcode.PREFIX) {
                break; // it goes on after the end
            }
            if (opcode == Opcode.FOOTER) {
                note("The end of the messages is not marked.");
                ended = true;
            } else if (opcode == Opcode.DATA_END) {
                sum(at, length, withSum);
                ended = true;
            } else {
                record(opcode, at, length);
                at += Opcode.PREFIX + length;
            }
        }
        endLoose();
        if (strays > 0) {
            note("%d messages are of channels that are not described; they are lost.".formatted(strays));
        }
        if (!ended) {
            note(
                    at == size
                            ? "The file has no end: it was cut off, or is still written, after byte %d.".formatted(at)
                            : "The file has no end: it was cut off or is damaged at byte %d; the %d bytes from there are lost."
                                    .formatted(at, size - at));
        }
        return contents;
    }

    private void sum(long at, long length, boolean withSum) throws IOException {
        int expected = length < 4
                ? 0
                : window.at(at + Opcode.PREFIX, 4)
                        .order(ByteOrder.LITTLE_ENDIAN)
                        .getInt();
        if (withSum && expected != 0 && expected != window.crc(0, at)) {
            note("The checksum of all data is not right.");
        }
    }

    private void record(int opcode, long at, long length) throws IOException {
        if (opcode == Opcode.MESSAGE) {
            loose(at, length);
            return;
        }
        endLoose();
        if (opcode == Opcode.CHUNK) {
            chunk(at, length);
            return;
        }
        boolean isMeant = opcode == Opcode.HEADER
                || opcode == Opcode.SCHEMA
                || opcode == Opcode.CHANNEL
                || opcode == Opcode.METADATA
                || opcode == Opcode.ATTACHMENT;
        if (!isMeant) {
            return;
        }
        try {
            if (opcode == Opcode.ATTACHMENT) {
                attachment(at, length);
            } else if (length > MOST_RECORD) {
                throw new Malformed("it has %d bytes; more than %d are not read".formatted(length, MOST_RECORD));
            } else {
                small(opcode, new RecordFields(window.at(at + Opcode.PREFIX, (int) length)));
            }
        } catch (Malformed e) {
            note("The record at byte %d is lost: %s.".formatted(at, e.getMessage()));
        }
    }

    private void small(int opcode, RecordFields fields) throws Malformed {
        switch (opcode) {
            case Opcode.HEADER -> {
                fields.string();
                contents.library = fields.string();
            }
            case Opcode.SCHEMA -> contents.schema(fields);
            case Opcode.CHANNEL -> contents.channel(fields);
            case Opcode.METADATA -> contents.metadata(fields);
            default -> throw new IllegalArgumentException("Opcode " + opcode);
        }
    }

    private void attachment(long at, long length) throws IOException, Malformed {
        contents.attachments.add(Attachments.entry(window, at, length));
    }

    private void loose(long at, long length) throws IOException {
        if (length < Opcode.MESSAGE_HEAD || length > Chunks.MOST - Opcode.PREFIX) {
            endLoose();
            note("The message at byte %d is lost: it has %d bytes.".formatted(at, length));
            return;
        }
        ByteBuffer head = window.at(at + Opcode.PREFIX, Opcode.MESSAGE_HEAD).order(ByteOrder.LITTLE_ENDIAN);
        if (looseLength + length > MOST_LOOSE) {
            endLoose();
        }
        int channel = Short.toUnsignedInt(head.getShort(0));
        long time = head.getLong(6);
        if (looseLength == 0) {
            looseAt = at;
            looseStart = time;
            looseEnd = time;
        }
        looseLength = at + Opcode.PREFIX + length - looseAt;
        looseStart = Math.min(looseStart, time);
        looseEnd = Math.max(looseEnd, time);
        count(channel, looseChannels);
    }

    private void endLoose() {
        if (looseLength > 0) {
            contents.blocks.add(new MessageBlock(looseAt, looseLength, false, looseStart, looseEnd, looseChannels));
        }
        looseLength = 0;
        looseChannels = new BitSet();
    }

    private void count(int channel, BitSet channels) {
        if (contents.channels.containsKey(channel)) {
            channels.set(channel);
            contents.counts.merge(channel, 1L, Long::sum);
        } else {
            strays++;
        }
    }

    private void chunk(long at, long length) throws IOException {
        var whole = new MessageBlock(at, Opcode.PREFIX + length, true, 0, 0, new BitSet());
        try {
            ByteBuffer records = chunks.records(whole, false);
            checkRecords(records);
            count(whole, records);
        } catch (Malformed e) {
            note("The chunk at byte %d, of %d bytes, is lost: %s.".formatted(at, length, e.getMessage()));
        }
    }

    /// Before any of them counts.
    private static void checkRecords(ByteBuffer records) throws Malformed {
        for (int next = 0; next < records.limit(); ) {
            next = Chunks.after(records, next);
        }
    }

    private void count(MessageBlock whole, ByteBuffer records) throws Malformed {
        var channels = new BitSet();
        long start = Long.MAX_VALUE;
        long end = Long.MIN_VALUE;
        for (int at = 0; at < records.limit(); ) {
            int next = Chunks.after(records, at);
            switch (records.get(at)) {
                case Opcode.SCHEMA -> contents.schema(Chunks.content(records, at, next));
                case Opcode.CHANNEL -> contents.channel(Chunks.content(records, at, next));
                case Opcode.MESSAGE -> {
                    long time = records.getLong(at + Opcode.PREFIX + 6);
                    start = Math.min(start, time);
                    end = Math.max(end, time);
                    count(Short.toUnsignedInt(records.getShort(at + Opcode.PREFIX)), channels);
                }
                default -> {} // of no use here
            }
            at = next;
        }
        if (start <= end) {
            contents.blocks.add(new MessageBlock(whole.offset(), whole.length(), true, start, end, channels));
        }
    }

    private void note(String damage) {
        if (++notes <= MOST_NOTES) {
            contents.damage.add(damage);
        } else if (notes == MOST_NOTES + 1) {
            contents.damage.add("There is more damage than can be listed.");
        }
    }
}
