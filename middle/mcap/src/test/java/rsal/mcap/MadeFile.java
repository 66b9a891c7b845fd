package rsal.mcap;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.Channels;
import java.nio.charset.StandardCharsets;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.random.RandomGenerator;

/// A file with messages made up by chance.
final class MadeFile {
    private static final String[] TOPICS = {"/poses", "/r1/scan", "/r2/scan", "/log", "/größe"};

    private final List<ObviousReader.Said> said = new ArrayList<>();
    private final ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    private long now; // real time [ns]

    /// @param messages how many there are to be
    /// @param disorder how far back the time of a message may be, in ns
    static MadeFile of(RandomGenerator random, int messages, int disorder) throws IOException {
        var made = new MadeFile();
        made.write(random, messages, disorder);
        return made;
    }

    private void write(RandomGenerator random, int messages, int disorder) throws IOException {
        try (var writer = new McapWriter(Channels.newChannel(bytes), "a test", () -> now)) {
            int schema = writer.schema("test.Text", "protobuf", new byte[] {1, 2, 3});
            var channels = new int[TOPICS.length];
            var counts = new long[TOPICS.length];
            writer.metadata(new Metadata("about", Map.of("seed", "7", "größe", "ä")));
            writer.attachment(new Attachment(5, 0, "notes.txt", "text/plain", data(random, 1000)));
            for (int i = 0; i < messages; i++) {
                int topic = random.nextInt(TOPICS.length);
                if (channels[topic] == 0) {
                    channels[topic] = writer.channel(schema, TOPICS[topic], "protobuf", Map.of("unit", "m"));
                }
                byte[] data = data(random, random.nextInt(20) == 0 ? 5000 : 40);
                long time = 1_000 + 100L * i - random.nextInt(disorder + 1);
                said.add(new ObviousReader.Said(
                        TOPICS[topic], ++counts[topic], time, time - 3, new String(data, StandardCharsets.ISO_8859_1)));
                writer.message(channels[topic], time, time - 3, ByteBuffer.wrap(data));
                now += random.nextInt(5_000_000);
                writer.tick();
            }
        }
    }

    private static byte[] data(RandomGenerator random, int most) {
        byte[] data = new byte[random.nextInt(most)];
        random.nextBytes(data);
        return data;
    }

    byte[] bytes() {
        return bytes.toByteArray();
    }

    /// What was written, in that order.
    List<ObviousReader.Said> said() {
        return said;
    }
}
