package rsal.mcap;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.mcap.ObviousReader.Said;
import rsal.testkit.Rounds;

class McapFileTest {
    private static final Comparator<Said> BY_TIME = Comparator.comparingLong(Said::logTime);

    @TempDir
    Path folder;

    @ParameterizedTest
    @ValueSource(ints = {0, 1, 2, 3, 4, 5, 6, 7, 8, 9})
    void whatIsWrittenIsRead(int seed) throws IOException {
        var random = new SplittableRandom(seed);
        MadeFile made = MadeFile.of(random, random.nextInt(4000), random.nextInt(2) * 500_000);
        assertThat(ObviousReader.of(made.bytes()).messages()).isEqualTo(made.said());

        List<Said> sorted = made.said().stream().sorted(BY_TIME).toList();
        try (McapFile file = McapFile.open(write(made.bytes()));
                McapFile checked = McapFile.check(folder.resolve("made.mcap"))) {
            assertThat(messages(file, Long.MIN_VALUE, Long.MAX_VALUE, _ -> true))
                    .isEqualTo(sorted);
            assertThat(messages(checked, Long.MIN_VALUE, Long.MAX_VALUE, _ -> true))
                    .isEqualTo(sorted);
            for (int i = 0; i < 20; i++) {
                long from = random.nextLong(400_000);
                long to = from + random.nextLong(100_000);
                String topic = random.nextBoolean() ? "/r1/scan" : "/größe";
                assertThat(messages(file, from, to, channel -> channel.topic().equals(topic)))
                        .isEqualTo(sorted.stream()
                                .filter(said -> said.logTime() >= from
                                        && said.logTime() <= to
                                        && said.topic().equals(topic))
                                .toList());
            }
            for (McapFile each : List.of(file, checked)) {
                assertThat(each.damage()).isEmpty();
                assertThat(each.library()).isEqualTo("a test");
                assertThat(each.metadata("about")).isEqualTo(Map.of("seed", "7", "größe", "ä"));
                assertThat(each.attachment(each.attachments().getFirst()).name())
                        .isEqualTo("notes.txt");
                assertThat(each.channels().stream().mapToLong(each::count).sum())
                        .isEqualTo(made.said().size());
                assertThat(each.start())
                        .isEqualTo(sorted.stream().mapToLong(Said::logTime).min());
                assertThat(each.end())
                        .isEqualTo(sorted.stream().mapToLong(Said::logTime).max());
            }
        }
    }

    @Test
    void aChunkIsWrittenWhenItIsOldOrLarge() throws IOException {
        MadeFile made = MadeFile.of(new SplittableRandom(1), 4000, 0); // 10 s, 800 kB
        try (McapFile file = McapFile.open(write(made.bytes()))) {
            assertThat(file.chunks()).isBetween(8, 12);
        }
    }

    /// Whatever is left, all of the chunks that are whole in it are read.
    @Test
    void whereverItIsCutOffItIsReadUpToThere() throws IOException {
        MadeFile made = MadeFile.of(new SplittableRandom(3), 1500, 0);
        byte[] bytes = made.bytes();
        long[] chunkEnds = chunkEnds(bytes);
        for (int length = 8; length < bytes.length; length += 1 + length / 97) {
            byte[] cut = Arrays.copyOf(bytes, length);
            try (McapFile file = McapFile.open(write(cut))) {
                List<Said> read = messages(file, Long.MIN_VALUE, Long.MAX_VALUE, _ -> true);
                assertThat(read).as("cut at %d", length).isEqualTo(made.said().subList(0, read.size()));
                int end = length;
                long whole = Arrays.stream(chunkEnds).filter(at -> at <= end).count();
                assertThat(file.chunks()).as("cut at %d", length).isEqualTo((int) whole);
                assertThat(file.damage()).isNotEmpty();
            }
        }
    }

    @Test
    void aDamagedChunkIsLeftOutAndReported() throws IOException {
        MadeFile made = MadeFile.of(new SplittableRandom(4), 3000, 0);
        byte[] bytes = made.bytes();
        bytes[(int) chunkEnds(bytes)[2] - 10] ^= 0x40;
        Path path = write(bytes);
        try (McapFile file = McapFile.open(path);
                McapFile checked = McapFile.check(path)) {
            List<Said> read = messages(file, Long.MIN_VALUE, Long.MAX_VALUE, _ -> true);
            assertThat(read).isNotEmpty().hasSizeLessThan(made.said().size());
            assertThat(made.said()).containsAll(read);
            assertThat(file.damage()).hasSize(1);
            assertThat(file.damage().getFirst()).contains("chunk at byte", "is lost");
            assertThat(checked.damage()).hasSize(2);
            assertThat(checked.damage().getLast()).contains("checksum of all data");
            assertThat(messages(checked, Long.MIN_VALUE, Long.MAX_VALUE, _ -> true))
                    .isEqualTo(read);
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 5, 6})
    void noBytesAreTooStrange(int seed) throws IOException {
        var random = new SplittableRandom(seed);
        byte[] good = MadeFile.of(random, 300, 0).bytes();
        for (int i = 0; i < Rounds.of(60, 300); i++) {
            byte[] bytes = good.clone();
            int changes = 1 + random.nextInt(8);
            for (int j = 0; j < changes; j++) {
                int at = 8 + random.nextInt(bytes.length - 8);
                if (random.nextInt(4) == 0 && at + 8 < bytes.length) { // a huge length
                    ByteBuffer.wrap(bytes)
                            .order(ByteOrder.LITTLE_ENDIAN)
                            .putLong(at, random.nextLong() >>> random.nextInt(64));
                } else {
                    bytes[at] = (byte) random.nextInt();
                }
            }
            readAll(write(bytes));
        }
        for (int i = 0; i < 300; i++) {
            byte[] noise = new byte[random.nextInt(3000)];
            random.nextBytes(noise);
            byte[] magic = Opcode.magic();
            System.arraycopy(magic, 0, noise, 0, Math.min(noise.length, magic.length));
            readAll(write(noise));
        }
    }

    /// Each length in the file, one after the other, says that there is far more.
    @Test
    void noLengthIsBelieved() throws IOException {
        byte[] good = MadeFile.of(new SplittableRandom(8), 60, 0).bytes();
        for (int at = 8; at + 8 < good.length; at += Rounds.of(41, 3)) {
            for (long huge : new long[] {-1, Long.MAX_VALUE, Integer.MAX_VALUE, 0xffff_ffffL, 60 << 20}) {
                byte[] bytes = good.clone();
                ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN).putLong(at, huge);
                readAll(write(bytes));
            }
        }
    }

    @Test
    void whatIsNoMcapIsRefused() throws IOException {
        Path path = write("no such thing".getBytes(StandardCharsets.UTF_8));
        assertThatThrownBy(() -> McapFile.open(path))
                .isInstanceOf(InvalidMcap.class)
                .hasMessageContaining("is not an MCAP file");
        assertThatThrownBy(() -> McapFile.open(write(new byte[0]))).isInstanceOf(InvalidMcap.class);
    }

    /// Files of others may have messages outside of chunks, and no index.
    @Test
    void messagesOutsideOfChunksAreRead() throws IOException {
        var sink = new ByteSink(100);
        sink.raw(Opcode.magic());
        record(sink, Opcode.HEADER, new ByteSink(10).string("").string("others"));
        record(
                sink,
                Opcode.CHANNEL,
                new ByteSink(10).u16(3).u16(0).string("/a").string("json").u32(0));
        for (int i = 0; i < 5; i++) {
            record(
                    sink,
                    Opcode.MESSAGE,
                    new ByteSink(30).u16(3).u32(i).u64(90 - i).u64(0).u8('a' + i));
        }
        record(sink, Opcode.DATA_END, new ByteSink(4).u32(0));
        record(sink, Opcode.FOOTER, new ByteSink(20).u64(0).u64(0).u32(0));
        sink.raw(Opcode.magic());
        try (McapFile file = McapFile.open(write(sink.toArray()))) {
            assertThat(file.damage()).isEmpty();
            assertThat(messages(file, 87, 89, _ -> true)).extracting(Said::data).containsExactly("d", "c", "b");
        }
    }

    private static void record(ByteSink sink, int opcode, ByteSink content) {
        sink.u8(opcode).u64(content.size()).raw(content.written());
    }

    private static void readAll(Path path) {
        try (McapFile file = McapFile.open(path)) {
            messages(file, Long.MIN_VALUE, Long.MAX_VALUE, _ -> true);
            for (AttachmentEntry entry : file.attachments()) {
                file.attachment(entry);
            }
        } catch (IOException e) {
            assertThat(e).isInstanceOf(InvalidMcap.class); // said, not stumbled upon
        }
    }

    private static List<Said> messages(McapFile file, long from, long to, Predicate<Channel> wanted)
            throws IOException {
        var all = new ArrayList<Said>();
        file.read(
                from,
                to,
                wanted,
                (channel, sequence, logTime, publishTime, data) -> all.add(new Said(
                        channel.topic(),
                        sequence,
                        logTime,
                        publishTime,
                        StandardCharsets.ISO_8859_1.decode(data).toString())));
        return all;
    }

    private static long[] chunkEnds(byte[] bytes) {
        var ends = new ArrayList<Long>();
        ByteBuffer in = ByteBuffer.wrap(bytes).order(ByteOrder.LITTLE_ENDIAN);
        for (int at = 8; at < bytes.length - 8; ) {
            int next = at + Opcode.PREFIX + (int) in.getLong(at + 1);
            if (bytes[at] == Opcode.CHUNK) {
                ends.add((long) next);
            }
            at = next;
        }
        return ends.stream().mapToLong(Long::longValue).toArray();
    }

    private Path write(byte[] bytes) throws IOException {
        return Files.write(folder.resolve("made.mcap"), bytes);
    }
}
