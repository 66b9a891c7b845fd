package rsal.ros2.sqlite;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.OptionalLong;
import java.util.zip.CRC32;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.testkit.OfficialPython;

/// What Python's `sqlite3` has written, which is SQLite itself, is read value by value.
class SqliteFileIT {
    private static final String SCRIPT = """
            import random, sqlite3, sys, zlib
            path, page, encoding, mode = sys.argv[1:]
            r = random.Random(int(page))
            db = sqlite3.connect(path)
            db.execute('PRAGMA page_size = ' + page)
            db.execute("PRAGMA encoding = '%s'" % encoding)
            db.execute('PRAGMA auto_vacuum = ' + ('FULL' if mode == 'vacuum' else 'NONE'))
            if mode == 'wal': db.execute('PRAGMA journal_mode = WAL')
            db.execute('CREATE TABLE other(x)')
            db.execute('CREATE TABLE "mixed" (id INTEGER PRIMARY KEY, number INTEGER, "a, b" TEXT, data BLOB, later REAL)')
            p = int(page)
            sizes = [0, 1, p - 40, p - 36, p - 35, p - 34, p - 30, p - 4, p, 2 * p, 2 * p + 7, 10 * p + 3, 300_000]
            for i in range(1500):
                n = r.choice([None, 0, 1, 2, -1, -128, 127, 128, -32769, 2**23, -2**31, 2**40, -2**47, 2**62, -2**63, r.randrange(-2**63, 2**63)])
                size = r.choice(sizes) if r.random() < 0.1 else r.randrange(200)
                db.execute('INSERT INTO mixed VALUES(?, ?, ?, ?, ?)', (None if r.random() < 0.9 else i * 1000 + 10**6, n, 'größe %d ' % i + 'x' * r.randrange(2 * p if r.random() < 0.03 else 30), r.randbytes(max(0, size)), r.choice([None, 1.5, 3.0])))
                db.execute('INSERT INTO other VALUES(?)', (i,))
            if mode == 'vacuum':
                db.execute('DELETE FROM mixed WHERE id % 3 = 0')
            db.commit()
            if mode == 'vacuum': db.execute('VACUUM')
            for row in db.execute('SELECT * FROM mixed ORDER BY id'):
                print(row[0], row[1], zlib.crc32(row[2].encode()), zlib.crc32(row[3]), len(row[3]))
            db.close()
            """;

    @TempDir
    private Path folder;

    @ParameterizedTest
    @CsvSource({"512,UTF-8,plain", "1024,UTF-16le,vacuum", "4096,UTF-8,wal", "4096,UTF-16be,plain", "65536,UTF-8,vacuum"
    })
    void allValuesAreRead(String page, String encoding, String mode) throws Exception {
        Path path = folder.resolve("mixed.db");
        List<String> expected = OfficialPython.run(SCRIPT, path.toString(), page, encoding, mode)
                .lines()
                .toList();
        var read = new ArrayList<String>();
        try (SqliteFile file = SqliteFile.open(path)) {
            SqliteTable table = file.table("mixed").orElseThrow();
            assertThat(table.columns()).containsExactly("id", "number", "a, b", "data", "later");
            file.read(table, row -> {
                OptionalLong number = row.integer(1);
                read.add("%d %s %d %d %d"
                        .formatted(
                                row.id(),
                                number.isPresent() ? number.getAsLong() : "None",
                                crc(row.text(2).getBytes(StandardCharsets.UTF_8)),
                                crc(row.data(3)),
                                row.data(3).length));
            });
            assertThat(file.damage()).isEmpty();
        }
        assertThat(read).isEqualTo(expected);
    }

    private static long crc(byte[] bytes) {
        var crc = new CRC32();
        crc.update(bytes);
        return crc.getValue();
    }
}
