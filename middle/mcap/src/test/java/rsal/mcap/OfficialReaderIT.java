package rsal.mcap;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import java.util.zip.CRC32;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.OfficialPython;

/// What is written here is read by the official Python package, with all checksums, by the index and without it.
class OfficialReaderIT {
    private static final String SCRIPT = """
            import sys, zlib
            from mcap.reader import SeekingReader, NonSeekingReader
            from mcap.stream_reader import StreamReader
            with open(sys.argv[1], "rb") as f:
                records = [type(r).__name__ for r in StreamReader(f, emit_chunks=True, validate_crcs=True).records]
                assert "DataEnd" in records and "Chunk" in records, records
            for kind in (SeekingReader, NonSeekingReader):
                with open(sys.argv[1], "rb") as f:
                    reader = kind(f, validate_crcs=True)
                    for schema, channel, m in reader.iter_messages(log_time_order=True):
                        print(channel.topic, m.sequence, m.log_time, m.publish_time, zlib.crc32(m.data), schema.name)
            with open(sys.argv[1], "rb") as f:
                reader = SeekingReader(f, validate_crcs=True)
                s = reader.get_summary().statistics
                print(s.message_count, s.channel_count, s.schema_count, s.attachment_count, s.metadata_count)
                print([(a.name, len(a.data)) for a in reader.iter_attachments()])
                print([(m.name, m.metadata["seed"]) for m in reader.iter_metadata()])
                print(sum(1 for _ in reader.iter_messages(topics=["/log"])))
            """;

    @TempDir
    Path folder;

    @Test
    void readsWhatWeWrite() throws Exception {
        MadeFile made = MadeFile.of(new SplittableRandom(11), 1500, 0);
        Path file = Files.write(folder.resolve("made.mcap"), made.bytes());
        List<String> lines = OfficialPython.run(SCRIPT, file.toString()).lines().toList();

        List<String> expected = made.said().stream()
                .sorted(Comparator.comparingLong(ObviousReader.Said::logTime))
                .map(OfficialReaderIT::line)
                .toList();
        assertThat(lines.subList(0, 1500)).isEqualTo(expected);
        assertThat(lines.subList(1500, 3000)).isEqualTo(expected);
        long log =
                made.said().stream().filter(said -> said.topic().equals("/log")).count();
        assertThat(lines.get(3000)).isEqualTo("1500 5 1 1 1");
        assertThat(lines.get(3001)).contains("notes.txt");
        assertThat(lines.get(3002)).isEqualTo("[('about', '7')]");
        assertThat(lines.get(3003)).isEqualTo(Long.toString(log));
    }

    private static String line(ObviousReader.Said said) {
        var crc = new CRC32();
        crc.update(said.data().getBytes(StandardCharsets.ISO_8859_1));
        return "%s %d %d %d %d test.Text"
                .formatted(said.topic(), said.sequence(), said.logTime(), said.publishTime(), crc.getValue());
    }
}
