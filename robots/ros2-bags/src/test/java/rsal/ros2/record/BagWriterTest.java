package rsal.ros2.record;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
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
        return BagWriter.folder(bag, force, "a test", now::get);
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
        Path other = Files.writeString(bag.resolve("run.mcap"), "another recording");
        Path moved = Files.move(bag, folder.resolve("moved"));
        begin(moved, true).close();
        assertThat(moved.resolve("bag_0.mcap")).doesNotExist();
        assertThat(List.of(moved.resolve(notes.getFileName()), moved.resolve(other.getFileName())))
                .allSatisfy(file -> assertThat(file).exists());
        assertThat(moved.resolve("metadata.yaml")).content().contains("message_count: 0", "[]");
    }

    /// Whatever may be lost by force: what is not a bag is not.
    @Test
    void aFolderOfSomethingElseIsKept() throws Exception {
        Path recording = Files.writeString(folder.resolve("run.mcap"), "a recording");
        assertThatThrownBy(() -> begin(folder, true)).isInstanceOf(FileAlreadyExistsException.class);
        Files.writeString(folder.resolve("metadata.yaml"), "name: a map\n");
        assertThatThrownBy(() -> begin(folder, true)).isInstanceOf(FileAlreadyExistsException.class);
        assertThat(recording).exists();
        assertThat(folder.resolve("metadata.yaml")).exists();
    }

    @Test
    void filesOfMetadataAreThoseWithin() throws Exception {
        Path metadata = folder.resolve("metadata.yaml");
        Files.writeString(metadata, """
                rosbag2_bagfile_information:
                  version: 5
                  relative_file_paths:
                    - run_0.db3
                    - "a \\"bag\\"_1.db3"
                    - ../other.db3
                  duration:
                    - nothing
                """);
        assertThat(BagMetadata.files(metadata)).hasValue(List.of("run_0.db3", "a \"bag\"_1.db3"));
    }

    @Test
    void aFileAloneHasNoFolder() throws Exception {
        Path file = folder.resolve("clock.mcap");
        try (BagWriter writer = BagWriter.file(file, false, "a test", now::get)) {
            write(writer, 3);
        }
        try (McapFile read = McapFile.check(file)) {
            assertThat(read.damage()).isEmpty();
            assertThat(read.metadata("rosbag2").get("serialized_metadata")).contains("message_count: 3");
        }
        assertThat(folder).isDirectoryNotContaining(each -> !each.equals(file));
    }

    @Test
    void unknownTypesAreRefused() throws Exception {
        try (BagWriter writer = begin(folder.resolve("bag"), false)) {
            assertThatThrownBy(() -> writer.topic("/a", "my_msgs/msg/Mine", OfferedQuality.RELIABLE))
                    .isInstanceOf(InvalidDefinition.class);
        }
    }
}
