package rsal.ros2.sqlite;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.channels.FileChannel;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;

/// A database of SQLite to be read, table by table, each from its first row to its last. A few pages are in memory at
/// once, and one value. Damaged parts are left out ([#damage]); no length and no page number is believed unchecked.
///
/// For one thread.
public final class SqliteFile implements Closeable {
    /// Larger rows are refused, whatever their lengths say [B].
    static final long MOST_ROW = 64L << 20;

    private static final byte[] MAGIC = "SQLite format 3\0".getBytes(StandardCharsets.US_ASCII);
    private static final byte[] JOURNAL_MAGIC = {(byte) 0xd9, (byte) 0xd5, 0x05, (byte) 0xf9};
    private static final int HEADER = 100; // B, on the first page
    private static final int WAL_HEADER = 32; // B
    private static final int LEAST_USABLE = 480; // B
    private static final int INTERIOR = 0x05; // kinds of pages of tables
    private static final int LEAF = 0x0d;
    private static final int MOST_LEVELS = 30; // trees of 2^31 pages have fewer
    private static final int MOST_TABLES = 1_000;
    private static final int MOST_NOTES = 100;

    private final Pages pages;
    private final Charset charset;
    private final ByteBuffer[] levels = new ByteBuffer[MOST_LEVELS];
    private final Map<String, SqliteTable> tables = new HashMap<>();
    private final List<String> damage = new ArrayList<>();
    private long visited; // pages of the table that is read

    private SqliteFile(Pages pages, Charset charset) {
        this.pages = pages;
        this.charset = charset;
    }

    /// Opens a file and reads which tables it has.
    ///
    /// @throws InvalidSqlite when it is not a database, or was not closed by the program that wrote it
    public static SqliteFile open(Path path) throws IOException {
        checkClosed(path);
        FileChannel file = FileChannel.open(path, StandardOpenOption.READ);
        try {
            var opened = open(path, file);
            opened.readTables();
            return opened;
        } catch (IOException | RuntimeException e) {
            file.close();
            throw e;
        }
    }

    private static SqliteFile open(Path path, FileChannel file) throws IOException {
        ByteBuffer header = ByteBuffer.allocate(HEADER).order(ByteOrder.BIG_ENDIAN);
        while (header.hasRemaining() && file.read(header, header.position()) >= 0) {}
        if (header.hasRemaining() || !header.slice(0, MAGIC.length).equals(ByteBuffer.wrap(MAGIC))) {
            throw new InvalidSqlite(
                    "File '%s' is not a database of SQLite: it does not begin like one.".formatted(path));
        }
        int reported = Short.toUnsignedInt(header.getShort(16));
        int size = reported == 1 ? 1 << 16 : reported;
        int usable = size - Byte.toUnsignedInt(header.get(20));
        if (Integer.bitCount(size) != 1 || size < 512 || usable < LEAST_USABLE) {
            throw new InvalidSqlite("File '%s' has a damaged header: its pages have %d bytes.".formatted(path, size));
        }
        int version = header.get(19);
        if (version < 1 || version > 2) {
            throw new InvalidSqlite(
                    "File '%s' is a database of SQLite in version %d; 1 and 2 can be read.".formatted(path, version));
        }
        Charset charset = switch (header.getInt(56)) {
            case 2 -> StandardCharsets.UTF_16LE;
            case 3 -> StandardCharsets.UTF_16BE;
            default -> StandardCharsets.UTF_8;
        };
        return new SqliteFile(new Pages(file, size, usable, file.size() / size), charset);
    }

    /// What a program has written last, or has to take back, may stand beside the file.
    private static void checkClosed(Path path) throws IOException {
        Path log = path.resolveSibling(path.getFileName() + "-wal");
        Path journal = path.resolveSibling(path.getFileName() + "-journal");
        boolean isOpen = (Files.exists(log) && Files.size(log) > WAL_HEADER) || begins(journal, JOURNAL_MAGIC);
        if (isOpen) {
            throw new InvalidSqlite(
                    "File '%s' was not closed: a part of it is in '%s'. Stop the recorder, or open the file once by sqlite3: sqlite3 FILE 'PRAGMA journal_mode=DELETE'."
                            .formatted(path, (Files.exists(log) ? log : journal).getFileName()));
        }
    }

    private static boolean begins(Path file, byte[] magic) throws IOException {
        if (!Files.exists(file)) {
            return false;
        }
        try (var in = Files.newInputStream(file)) {
            return ByteBuffer.wrap(in.readNBytes(magic.length)).equals(ByteBuffer.wrap(magic));
        }
    }

    private void readTables() throws IOException {
        var schema = new SqliteTable("sqlite_schema", 1, List.of("type", "name", "tbl_name", "rootpage", "sql"));
        read(schema, row -> {
            boolean isTable = row.text(0).equals("table") && tables.size() < MOST_TABLES;
            if (isTable) {
                String name = row.text(1).toLowerCase(Locale.ROOT);
                tables.put(name, SqliteTable.of(name, row.integer(3).orElse(0), row.text(4)));
            }
        });
    }

    /// @param name in small letters
    public Optional<SqliteTable> table(String name) {
        return Optional.ofNullable(tables.get(name));
    }

    /// What is wrong with the file and lost, a sentence each, as far as it was found yet.
    public List<String> damage() {
        return List.copyOf(damage);
    }

    /// Reads all rows, in the order of their ids. An [InvalidSqlite] of the visitor, which values that are damaged
    /// throw, leaves out the row.
    public void read(SqliteTable table, RowVisitor visitor) throws IOException {
        visited = 0;
        read(table.root(), 0, new SqliteRow(pages, charset), visitor);
    }

    private void read(long number, int level, SqliteRow row, RowVisitor visitor) throws IOException {
        ByteBuffer page = level(level);
        int head = number == 1 ? HEADER : 0;
        try {
            if (++visited > pages.count()) {
                throw new InvalidSqlite("It is in a circle of pages");
            }
            pages.read(number, page);
            if (page.get(head) == LEAF) {
                int cells = cells(page, head + 8, Short.toUnsignedInt(page.getShort(head + 3)));
                for (int i = 0; i < cells; i++) {
                    visit(page, head + 8 + 2 * i, row, visitor);
                }
            } else if (page.get(head) == INTERIOR && level + 1 < MOST_LEVELS) {
                readChildren(page, head, level, row, visitor);
            } else {
                throw new InvalidSqlite("It is of kind %d, not of a table".formatted(page.get(head)));
            }
        } catch (InvalidSqlite e) {
            note("Page %d is lost: %s.".formatted(number, e.getMessage()));
        }
    }

    private void readChildren(ByteBuffer page, int head, int level, SqliteRow row, RowVisitor visitor)
            throws IOException {
        int cells = cells(page, head + 12, Short.toUnsignedInt(page.getShort(head + 3)));
        for (int i = 0; i < cells && visited <= pages.count(); i++) {
            int at = Short.toUnsignedInt(page.getShort(head + 12 + 2 * i));
            if (at > pages.usable() - Integer.BYTES) {
                throw new InvalidSqlite("A cell goes beyond its page");
            }
            read(Integer.toUnsignedLong(page.getInt(at)), level + 1, row, visitor);
        }
        read(Integer.toUnsignedLong(page.getInt(head + 8)), level + 1, row, visitor);
    }

    /// The number of cells, if their places fit on the page.
    private int cells(ByteBuffer page, int from, int count) throws InvalidSqlite {
        if (from + 2 * count > Math.min(pages.usable(), page.limit())) {
            throw new InvalidSqlite("It has %d cells".formatted(count));
        }
        return count;
    }

    private void visit(ByteBuffer page, int pointer, SqliteRow row, RowVisitor visitor) throws IOException {
        try {
            row.set(page, Short.toUnsignedInt(page.getShort(pointer)));
            visitor.row(row);
        } catch (InvalidSqlite e) {
            note("A row of the table is lost: %s.".formatted(e.getMessage()));
        }
    }

    private ByteBuffer level(int level) {
        if (levels[level] == null) {
            levels[level] = pages.room();
        }
        return levels[level];
    }

    private void note(String what) {
        if (damage.size() < MOST_NOTES) {
            damage.add(what);
        } else if (damage.size() == MOST_NOTES) {
            damage.add("There is more damage than can be listed.");
        }
    }

    @Override
    public void close() throws IOException {
        pages.file().close();
    }
}
