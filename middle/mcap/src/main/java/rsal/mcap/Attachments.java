package rsal.mcap;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;

/// Reads attachments.
final class Attachments {
    private static final long MOST = 256 << 20; // [B] that are read at once
    private static final int MOST_HEAD = 8 + 8 + 4 + 4 + 8 + (1 << 12); // with its name and type

    private Attachments() {}

    /// What a record says of its attachment, checked.
    static AttachmentEntry entry(FileWindow window, long at, long length) throws IOException, Malformed {
        int head = (int) Math.min(length, MOST_HEAD);
        var fields = new RecordFields(window.at(at + Opcode.PREFIX, head));
        long logTime = fields.u64();
        fields.u64();
        String name = fields.string();
        String mediaType = fields.string();
        long size = fields.u64();
        int from = head - fields.remaining();
        if (size < 0 || size != length - from - 4) {
            throw new Malformed("its lengths do not match");
        }
        int expected = window.at(at + Opcode.PREFIX + length - 4, 4)
                .order(ByteOrder.LITTLE_ENDIAN)
                .getInt();
        if (expected != 0 && expected != window.crc(at + Opcode.PREFIX, length - 4)) {
            throw new Malformed("its checksum is not right");
        }
        return new AttachmentEntry(name, mediaType, logTime, at, Opcode.PREFIX + length, size);
    }

    /// @throws InvalidMcap when it is damaged or too large
    static Attachment read(FileWindow window, AttachmentEntry entry) throws IOException {
        try {
            long length = entry.length() - Opcode.PREFIX;
            if (length < 0 || length > MOST) {
                throw new Malformed("it has %d bytes; more than %d are not read".formatted(length, MOST));
            }
            ByteBuffer prefix = window.at(entry.offset(), Opcode.PREFIX).order(ByteOrder.LITTLE_ENDIAN);
            if (prefix.get(0) != Opcode.ATTACHMENT || prefix.getLong(1) != length) {
                throw new Malformed("it is not where the index says");
            }
            AttachmentEntry known = entry(window, entry.offset(), length);
            var fields = new RecordFields(window.at(entry.offset() + Opcode.PREFIX, (int) length));
            long logTime = fields.u64();
            long createTime = fields.u64();
            fields.string();
            fields.string();
            fields.u64();
            byte[] data = new byte[(int) known.size()];
            window.at(entry.offset() + entry.length() - 4 - known.size(), data.length)
                    .get(data);
            return new Attachment(logTime, createTime, known.name(), known.mediaType(), data);
        } catch (Malformed e) {
            throw new InvalidMcap("Attachment '%s' is lost: %s.".formatted(entry.name(), e.getMessage()));
        }
    }
}
