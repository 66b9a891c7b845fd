package rsal.mcap;

import com.github.luben.zstd.Zstd;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;

/// Reads a whole file the slow and obvious way: from its first byte to its last, with nothing checked.
final class ObviousReader {
    private final Map<Integer, String> topics = new HashMap<>();
    private final List<Said> messages = new ArrayList<>();
    private final List<String> kinds = new ArrayList<>();

    /// @param data as text, each byte a character
    record Said(String topic, long sequence, long logTime, long publishTime, String data) {}

    static ObviousReader of(byte[] file) {
        var reader = new ObviousReader();
        reader.records(little(file).slice(8, file.length - 16).order(ByteOrder.LITTLE_ENDIAN));
        return reader;
    }

    /// In the order of the file.
    List<Said> messages() {
        return messages;
    }

    /// Opcodes in hexadecimal, in the order of the file; without those in chunks.
    List<String> kinds() {
        return kinds;
    }

    private void records(ByteBuffer in) {
        while (in.hasRemaining()) {
            int opcode = in.get();
            int length = (int) in.getLong();
            ByteBuffer content = in.slice(in.position(), length).order(ByteOrder.LITTLE_ENDIAN);
            in.position(in.position() + length);
            kinds.add("%02x".formatted(opcode));
            switch (opcode) {
                case 0x04 -> {
                    int id = content.getShort();
                    content.getShort();
                    byte[] topic = new byte[content.getInt()];
                    content.get(topic);
                    topics.put(id, new String(topic, StandardCharsets.UTF_8));
                }
                case 0x05 ->
                    messages.add(new Said(
                            topics.get((int) content.getShort()),
                            content.getInt(),
                            content.getLong(),
                            content.getLong(),
                            text(content, content.remaining())));
                case 0x06 -> {
                    content.position(16);
                    int size = (int) content.getLong();
                    content.getInt();
                    text(content, content.getInt());
                    byte[] compressed = new byte[(int) content.getLong()];
                    content.get(compressed);
                    int outer = kinds.size();
                    records(little(Zstd.decompress(compressed, size)));
                    kinds.subList(outer, kinds.size()).clear();
                }
                default -> {} // not asked for
            }
        }
    }

    private static ByteBuffer little(byte[] bytes) {
        return ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
    }

    private static String text(ByteBuffer in, int length) {
        byte[] bytes = new byte[length];
        in.get(bytes);
        return new String(bytes, StandardCharsets.ISO_8859_1);
    }
}
