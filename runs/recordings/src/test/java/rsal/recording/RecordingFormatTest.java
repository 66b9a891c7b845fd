package rsal.recording;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.channels.FileChannel;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.mcap.McapWriter;
import rsal.mcap.Metadata;
import rsal.settings.InvalidSettings;

/// Recordings of other versions of RSAL.
class RecordingFormatTest {
    @TempDir
    private Path folder;

    private String recording(Map<String, String> origin) throws IOException {
        Path file = folder.resolve("run.mcap");
        var channel = FileChannel.open(file, StandardOpenOption.CREATE, StandardOpenOption.WRITE);
        try (var writer = new McapWriter(channel, "a test", () -> 0)) {
            writer.metadata(new Metadata(Origin.NAME, origin));
        }
        return file.toString();
    }

    @Test
    void oneFromBeforeThereWereVersionsIsRead() throws IOException {
        assertThat(Recording.open(recording(Map.of("seed", "7")), false).run()).containsEntry("seed", "7");
    }

    @Test
    void oneOfANewerVersionIsRefusedWithTheProgramThatMadeIt() throws IOException {
        String file = recording(Map.of("format", "2", "program", "rsal 9.0.0"));
        assertThatThrownBy(() -> Recording.open(file, false))
                .isInstanceOf(InvalidSettings.class)
                .hasMessageContaining("This recording has format '2'; this RSAL reads format 1.")
                .hasMessageContaining("It was made by 'rsal 9.0.0': use that, or a newer one.");
    }
}
