package rsal.ros2.sqlite;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.charset.Charset;
import java.util.Arrays;
import java.util.OptionalLong;

/// A row of a table. What is on other pages (*overflow*) is read when it is asked for.
public final class SqliteRow {
    private static final int MOST_COLUMNS = 100; // of tables that are read here
    private static final int FIRST_LENGTH = 12; // of types of bytes and texts
    private static final int[] NUMBER_SIZES = {0, 1, 2, 3, 4, 6, 8, 8, 0, 0}; // by type
    private static final int FLOAT = 7;
    private static final int ZERO = 8; // the number 0 itself; 9 is 1

    private final Pages pages;
    private final Charset charset;
    private final ByteBuffer overflow; // a page
    private final long[] types = new long[MOST_COLUMNS];
    private final long[] offsets = new long[MOST_COLUMNS]; // in the record [B]
    private ByteBuffer page;
    private int from; // of the record, in the page
    private int local; // bytes of it in the page
    private long length; // of the record
    private long next; // page of the rest; 0 for none
    private long id;
    private int columns;

    SqliteRow(Pages pages, Charset charset) {
        this.pages = pages;
        this.charset = charset;
        this.overflow = pages.room();
        this.page = overflow;
    }

    /// The row in a cell of a page.
    ///
    /// @param at where the cell begins
    void set(ByteBuffer leaf, int at) throws InvalidSqlite {
        page = leaf;
        var cell = new Varints(leaf, at, pages.usable());
        length = cell.next();
        id = cell.next();
        from = cell.position();
        if (length < 0 || length > SqliteFile.MOST_ROW || length > pages.count() * pages.usable()) {
            throw new InvalidSqlite("A row says that it has %s bytes".formatted(Long.toUnsignedString(length)));
        }
        local = (int) localLength(length, pages.usable());
        boolean isSplit = local < length;
        if (from + local + (isSplit ? Integer.BYTES : 0) > pages.usable()) {
            throw new InvalidSqlite("A row goes beyond its page");
        }
        next = isSplit ? Integer.toUnsignedLong(leaf.getInt(from + local)) : 0;
        readTypes();
    }

    /// How much of a record is on its page, after *B-tree Cell Format*.
    private static long localLength(long length, int usable) {
        int most = usable - 35;
        if (length <= most) {
            return length;
        }
        int least = (usable - 12) * 32 / 255 - 23;
        long wanted = least + (length - least) % (usable - 4);
        return wanted <= most ? wanted : least;
    }

    private void readTypes() throws InvalidSqlite {
        var header = new Varints(page, from, from + local);
        long size = header.next();
        if (size < 1 || size > local) {
            throw new InvalidSqlite("A row has a header of %s bytes".formatted(Long.toUnsignedString(size)));
        }
        long offset = size;
        columns = 0;
        while (header.position() < from + size && columns < MOST_COLUMNS) {
            types[columns] = header.next();
            offsets[columns] = offset;
            offset += size(types[columns]);
            if (offset > length) {
                throw new InvalidSqlite("A row has values that are longer than the row");
            }
            columns++;
        }
    }

    private static long size(long type) throws InvalidSqlite {
        if (type >= FIRST_LENGTH) {
            return (type - FIRST_LENGTH) / 2;
        }
        if (type < 0 || type >= NUMBER_SIZES.length) {
            throw new InvalidSqlite("A value has the unknown type %d".formatted(type));
        }
        return NUMBER_SIZES[(int) type];
    }

    /// Its number in the table, which is also the value of a column that is an `INTEGER PRIMARY KEY`.
    public long id() {
        return id;
    }

    /// A whole number; empty where there is none.
    ///
    /// @param column from 0; rows may have fewer columns than their table
    public OptionalLong integer(int column) throws IOException {
        boolean isInteger = column >= 0
                && column < columns
                && types[column] > 0
                && types[column] < FIRST_LENGTH
                && types[column] != FLOAT;
        if (!isInteger) {
            return OptionalLong.empty();
        }
        if (types[column] >= ZERO) {
            return OptionalLong.of(types[column] - ZERO);
        }
        byte[] bytes = bytes(column);
        long value = bytes[0]; // with its sign
        for (int i = 1; i < bytes.length; i++) {
            value = value << Byte.SIZE | Byte.toUnsignedInt(bytes[i]);
        }
        return OptionalLong.of(value);
    }

    /// A text; an empty one where there is none.
    ///
    /// @param column the same
    public String text(int column) throws IOException {
        return isData(column) ? new String(bytes(column), charset) : "";
    }

    /// Bytes, or those of a text; none where there is no such value.
    ///
    /// @param column the same
    public byte[] data(int column) throws IOException {
        return isData(column) ? bytes(column) : new byte[0];
    }

    private boolean isData(int column) {
        return column >= 0 && column < columns && types[column] >= FIRST_LENGTH;
    }

    private byte[] bytes(int column) throws IOException {
        long offset = offsets[column];
        var bytes = new byte[(int) size(types[column])];
        int done = 0;
        if (offset < local) {
            done = (int) Math.min(bytes.length, local - offset);
            page.get(from + (int) offset, bytes, 0, done);
        }
        long begin = local; // of the next page, in the record
        long number = next;
        while (done < bytes.length) {
            pages.read(number, overflow);
            number = Integer.toUnsignedLong(overflow.getInt(0));
            int room = pages.usable() - Integer.BYTES;
            long at = offset + done - begin;
            if (at < room) {
                int part = (int) Math.min(bytes.length - done, room - at);
                overflow.get(Integer.BYTES + (int) at, bytes, done, part);
                done += part;
            }
            begin += room;
        }
        return bytes;
    }

    /// For people who look for an error.
    @Override
    public String toString() {
        return "row %d: %d B, types %s".formatted(id, length, Arrays.toString(Arrays.copyOf(types, columns)));
    }
}
