package rsal.ros2.sqlite;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import java.util.TreeSet;
import java.util.zip.GZIPInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import rsal.testkit.Rounds;

/// With a bag as recorders of Humble have them, in pages of 512 bytes. It was made by `bag.py odom small
/// sqlite3/humble small`.
class SqliteFileTest {
    @TempDir
    private Path folder;

    private static byte[] whole() throws IOException {
        try (var in = new GZIPInputStream(
                Objects.requireNonNull(SqliteFileTest.class.getResourceAsStream("/small.db3.gz")))) {
            return in.readAllBytes();
        }
    }

    private Path write(byte[] bytes) throws IOException {
        return Files.write(folder.resolve("small.db3"), bytes);
    }

    /// Reads all values of all rows.
    private static int rows(SqliteFile file, String name) throws IOException {
        int[] rows = {0};
        SqliteTable table = file.table(name).orElse(null);
        if (table != null) {
            file.read(table, row -> {
                for (int i = -1; i <= table.columns().size(); i++) {
                    row.integer(i);
                    row.data(i);
                }
                rows[0]++;
            });
        }
        return rows[0];
    }

    @Test
    void tablesAreFoundByName() throws IOException {
        try (SqliteFile file = SqliteFile.open(write(whole()))) {
            assertThat(file.table("topics").orElseThrow().columns())
                    .containsExactly("id", "name", "type", "serialization_format", "offered_qos_profiles");
            assertThat(file.table("messages").orElseThrow().column("data")).isEqualTo(3);
            assertThat(file.table("message_definitions")).isEmpty();
            assertThat(file.damage()).isEmpty();
        }
    }

    @Test
    void rowsHaveTheirValues() throws IOException {
        var types = new HashMap<String, String>();
        try (SqliteFile file = SqliteFile.open(write(whole()))) {
            file.read(file.table("topics").orElseThrow(), row -> types.put(row.text(1), row.text(2)));
            assertThat(types)
                    .isEqualTo(Map.of(
                            "/r1/scan", "sensor_msgs/msg/LaserScan",
                            "/r1/odom", "nav_msgs/msg/Odometry",
                            "/r1/tf", "tf2_msgs/msg/TFMessage",
                            "/r1/tf_static", "tf2_msgs/msg/TFMessage",
                            "/image", "sensor_msgs/msg/Image"));
            var lengths = new HashMap<Integer, Integer>();
            file.read(file.table("messages").orElseThrow(), row -> {
                byte[] data = row.data(3);
                assertThat(data).startsWith(0, 1, 0, 0);
                lengths.merge(data.length, 1, Integer::sum);
            });
            assertThat(lengths).containsEntry(724, 20); // odometry, which overflows its page
            assertThat(lengths.values().stream().mapToInt(i -> i).sum()).isEqualTo(61);
        }
    }

    @Test
    void columnsAreFoundWhateverTheirQuotes() {
        assertThat(SqliteTable.of(
                                "t",
                                2,
                                "CREATE TABLE \"t(\" (\"Id, \" INTEGER, [b c] TEXT DEFAULT ('x,y'), `d` DECIMAL(3, 2), e)")
                        .columns())
                .containsExactly("id, ", "b c", "d", "e");
        assertThat(SqliteTable.of("t", 2, "").columns()).isEmpty();
    }

    @Test
    void whatIsNoDatabaseIsRefused() throws IOException {
        Path empty = write(new byte[0]);
        assertThatThrownBy(() -> SqliteFile.open(empty)).isInstanceOf(InvalidSqlite.class);
        Path text = write("SQLite format 2".repeat(100).getBytes(StandardCharsets.UTF_8));
        assertThatThrownBy(() -> SqliteFile.open(text))
                .isInstanceOf(InvalidSqlite.class)
                .hasMessageContaining("does not begin like one");
    }

    @Test
    void whatWasNotClosedIsRefused() throws IOException {
        Path file = write(whole());
        Path log = Files.write(folder.resolve("small.db3-wal"), new byte[600]);
        assertThatThrownBy(() -> SqliteFile.open(file))
                .isInstanceOf(InvalidSqlite.class)
                .hasMessageContaining("was not closed", "small.db3-wal");
        Files.write(log, new byte[0]);
        SqliteFile.open(file).close();
    }

    /// Wherever it is cut, what is whole in it is read, and the rest is damage.
    @Test
    void whatWasCutOffIsReadUpToThere() throws IOException {
        byte[] whole = whole();
        for (int length = 1024; length < whole.length; length += 512) {
            try (SqliteFile file = SqliteFile.open(write(Arrays.copyOf(whole, length)))) {
                int rows = rows(file, "messages");
                assertThat(rows < 61)
                        .as("%d of %d rows", rows, 61)
                        .isEqualTo(!file.damage().isEmpty());
            }
        }
    }

    /// No crash, no end that does not come, nothing larger than the file.
    @Test
    void noBytesAreTooStrange() throws IOException {
        byte[] whole = whole();
        var random = new SplittableRandom(7);
        Path path = write(whole);
        try (FileChannel channel = FileChannel.open(path, StandardOpenOption.WRITE)) {
            for (int i = 0; i < Rounds.of(2_000, 1_000_000); i++) {
                var changed = new TreeSet<Integer>();
                for (int k = random.nextInt(1, 12); k > 0; k--) {
                    int inPage = random.nextInt(random.nextBoolean() ? 24 : 512); // heads of pages more often
                    changed.add(Math.max(16, 512 * random.nextInt(whole.length / 512) + inPage));
                }
                for (int at : changed) {
                    int value = random.nextBoolean() ? random.nextInt() : random.nextInt(4) - 2;
                    channel.write(ByteBuffer.wrap(new byte[] {(byte) value}), at);
                }
                readAll(path);
                for (int at : changed) {
                    channel.write(ByteBuffer.wrap(whole, at, 1), at);
                }
            }
        }
        readAll(path);
    }

    private static void readAll(Path path) throws IOException {
        try (SqliteFile file = SqliteFile.open(path)) {
            for (String table : new String[] {"topics", "messages"}) {
                assertThat(rows(file, table)).isLessThan(48 * 512);
            }
        } catch (InvalidSqlite e) {
            assertThat(e).hasMessageContaining("small.db3");
        }
    }
}
