package rsal.mcap;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.zip.CRC32;
import net.jpountz.lz4.LZ4FrameOutputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.Rounds;

/// Chunks that are compressed by LZ4, as bags of ROS 2 may have them.
class Lz4ChunkTest {
    private static final List<String> TEXTS =
            IntStream.range(0, 200).mapToObj(i -> "message %d".formatted(i)).toList();

    @TempDir
    private Path folder;

    private static byte[] file() throws IOException {
        var records = new ByteSink(1 << 10);
        for (int i = 0; i < TEXTS.size(); i++) {
            byte[] text = TEXTS.get(i).getBytes(StandardCharsets.UTF_8);
            record(
                    records,
                    Opcode.MESSAGE,
                    new ByteSink(64).u16(1).u32(i).u64(i).u64(i).raw(text));
        }
        var crc = new CRC32();
        crc.update(records.toArray());
        var compressed = new ByteArrayOutputStream();
        try (var lz4 = new LZ4FrameOutputStream(compressed)) {
            lz4.write(records.toArray());
        }
        var sink = new ByteSink(1 << 10).raw(Opcode.magic());
        record(sink, Opcode.HEADER, new ByteSink(10).string("").string("others"));
        record(
                sink,
                Opcode.CHANNEL,
                new ByteSink(10).u16(1).u16(0).string("/a").string("text").u32(0));
        record(
                sink,
                Opcode.CHUNK,
                new ByteSink(1 << 10)
                        .u64(0)
                        .u64(TEXTS.size() - 1)
                        .u64(records.size())
                        .u32((int) crc.getValue())
                        .string("lz4")
                        .u64(compressed.size())
                        .raw(compressed.toByteArray()));
        record(sink, Opcode.DATA_END, new ByteSink(4).u32(0));
        record(sink, Opcode.FOOTER, new ByteSink(20).u64(0).u64(0).u32(0));
        return sink.raw(Opcode.magic()).toArray();
    }

    private static void record(ByteSink sink, int opcode, ByteSink content) {
        sink.u8(opcode).u64(content.size()).raw(content.written());
    }

    private List<String> read(byte[] bytes) throws IOException {
        Path path = Files.write(folder.resolve("made.mcap"), bytes);
        var texts = new ArrayList<String>();
        try (McapFile file = McapFile.open(path)) {
            file.read(
                    _ -> true,
                    (_, _, _, _, data) ->
                            texts.add(StandardCharsets.UTF_8.decode(data).toString()));
            assertThat(texts.isEmpty()).isNotEqualTo(file.damage().isEmpty());
        }
        return texts;
    }

    @Test
    void areRead() throws IOException {
        assertThat(read(file())).isEqualTo(TEXTS);
    }

    /// Behind the chunk's head, all bytes are covered by its checksum or tell how to decompress it.
    @Test
    void areLeftOutWhenTheyAreDamaged() throws IOException {
        byte[] whole = file();
        var random = new SplittableRandom(5);
        int end = whole.length - 50; // in the compressed data
        for (int i = 0; i < Rounds.of(500, 200_000); i++) {
            byte[] damaged = whole.clone();
            for (int k = random.nextInt(1, 5); k > 0; k--) {
                damaged[random.nextInt(end - 300, end)] = (byte) random.nextInt();
            }
            List<String> texts = read(damaged);
            assertThat(texts.isEmpty() || texts.equals(TEXTS)).isTrue();
        }
    }
}
