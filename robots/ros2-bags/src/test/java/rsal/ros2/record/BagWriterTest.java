package rsal.ros2.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.concurrent.atomic.AtomicLong;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.mcap.McapFile;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.InvalidDefinition;

class BagWriterTest {
    private static final String CLOCK = "rosgraph_msgs/msg/Clock";
    private static final long SECOND = 1_000_000_000; // ns

    @TempDir
    private Path folder;

    private final AtomicLong now = new AtomicLong();

    private BagWriter begin(Path bag, boolean force) throws IOException {
        return BagWriter.create(bag, force, "a test", now::get);
    }

    private void write(BagWriter bag, int seconds) throws IOException {
        int clock = bag.topic("/clock", CLOCK, OfferedQuality.BEST_EFFORT);
        for (int i = 1; i <= seconds; i++) {
            now.set(i * SECOND);
            bag.message(clock, now.get(), new RosMessages().clock(Instant.ofEpochSecond(i)));
        }
    }

    @Test
    void metadataCountsMessagesAndTimes() throws Exception {
        Path bag = folder.resolve("a \"bag\"");
        try (BagWriter writer = begin(bag, false)) {
            write(writer, 5);
        }
        assertThat(bag.resolve("metadata.yaml"))
                .content()
                .contains(
                        "message_count: 5",
                        "starting_time:\n    nanoseconds_since_epoch: 1000000000",
                        "duration:\n    nanoseconds: 4000000000",
                        "- \"a \\\"bag\\\"_0.mcap\"",
                        "name: /clock",
                        "type_description_hash: RIHS01_",
                        "reliability: best_effort");
    }

    /// As when the process is killed.
    @Test
    void whatWasNotClosedIsReadable() throws Exception {
        Path bag = folder.resolve("bag");
        write(begin(bag, false), 10);
        try (McapFile file = McapFile.open(bag.resolve("bag_0.mcap"))) {
            assertThat(file.channels()).hasSize(1);
            assertThat(file.count(file.channels().iterator().next())).isGreaterThanOrEqualTo(8); // one is not written
            assertThat(file.damage()).hasSize(1);
        }
        assertThat(bag.resolve("metadata.yaml")).content().contains("message_count: 0", "bag_0.mcap");
    }

    @Test
    void aBagThatIsThereIsKeptUnlessForced() throws Exception {
        Path bag = folder.resolve("bag");
        try (BagWriter writer = begin(bag, false)) {
            write(writer, 3);
        }
        Path notes = Files.writeString(bag.resolve("notes.txt"), "mine");
        assertThatThrownBy(() -> begin(bag, false)).isInstanceOf(FileAlreadyExistsException.class);
        Files.move(bag.resolve("bag_0.mcap"), bag.resolve("bag_1.mcap"));
        begin(bag, true).close();
        assertThat(bag.resolve("bag_1.mcap")).doesNotExist();
        assertThat(notes).exists();
        assertThat(bag.resolve("metadata.yaml")).content().contains("message_count: 0", "[]");
    }

    @Test
    void aFileAloneHasNoFolder() throws Exception {
        Path file = folder.resolve("clock.mcap");
        try (BagWriter writer = begin(file, false)) {
            write(writer, 3);
        }
        try (McapFile read = McapFile.check(file)) {
            assertThat(read.damage()).isEmpty();
            assertThat(read.metadata("rosbag2").get("serialized_metadata")).contains("message_count: 3");
        }
        assertThat(folder).isDirectoryContaining("glob:**clock.mcap");
    }

    @Test
    void unknownTypesAreRefused() throws Exception {
        try (BagWriter writer = begin(folder.resolve("bag"), false)) {
            assertThatThrownBy(() -> writer.topic("/a", "my_msgs/msg/Mine", OfferedQuality.RELIABLE))
                    .isInstanceOf(InvalidDefinition.class);
        }
    }
}
