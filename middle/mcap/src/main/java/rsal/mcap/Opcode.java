package rsal.mcap;

/// What a record is, in its first byte. The length of its content follows in eight.
final class Opcode {
    static final int HEADER = 0x01;
    static final int FOOTER = 0x02;
    static final int SCHEMA = 0x03;
    static final int CHANNEL = 0x04;
    static final int MESSAGE = 0x05;
    static final int CHUNK = 0x06;
    static final int MESSAGE_INDEX = 0x07;
    static final int CHUNK_INDEX = 0x08;
    static final int ATTACHMENT = 0x09;
    static final int ATTACHMENT_INDEX = 0x0A;
    static final int STATISTICS = 0x0B;
    static final int METADATA = 0x0C;
    static final int METADATA_INDEX = 0x0D;
    static final int SUMMARY_OFFSET = 0x0E;
    static final int DATA_END = 0x0F;

    /// Opcode and length.
    static final int PREFIX = 1 + Long.BYTES;

    /// Of a message, before its data: channel, sequence, two times.
    static final int MESSAGE_HEAD = 2 + 4 + 8 + 8;

    /// Content of a footer.
    static final int FOOTER_LENGTH = 8 + 8 + 4;

    private static final byte[] MAGIC = {(byte) 0x89, 'M', 'C', 'A', 'P', '0', '\r', '\n'};

    private Opcode() {}

    /// What files begin and end with.
    static byte[] magic() {
        return MAGIC.clone();
    }
}
