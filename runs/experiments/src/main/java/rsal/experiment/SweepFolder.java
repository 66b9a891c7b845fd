package rsal.experiment;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.HashSet;
import java.util.List;
import java.util.TreeMap;
import java.util.stream.Collectors;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import tools.jackson.core.JacksonException;
import tools.jackson.databind.MapperFeature;
import tools.jackson.databind.SerializationFeature;
import tools.jackson.databind.json.JsonMapper;

/// Where an experiment's rows are kept. Safe for several threads; while it is open, no other process can
/// write to it.
///
/// What counts is `rows.jsonl`, a row per line in the order in which runs ended. A row is there once
/// [#append] has returned, whatever happens to the process or the machine: it is written in one piece and
/// forced to the disk. When a kill or a full disk leaves half a row behind, [#resume] cuts it off. `rows.csv`
/// has the same for spreadsheets and statistics; it is made again from the other whenever the folder is
/// opened, and sorted when all runs have ended.
public final class SweepFolder implements AutoCloseable {
    public static final String MANIFEST = "manifest.json";
    public static final String ROWS = "rows.jsonl";
    public static final String TABLE = "rows.csv";

    private static final int BLOCK = 1 << 16; // [byte]
    private static final String PART = ".part"; // of a file that is not complete yet
    private static final JsonMapper JSON = JsonMapper.builder()
            .disable(MapperFeature.SORT_PROPERTIES_ALPHABETICALLY)
            .build();

    private final Path folder;
    private final FileChannel rows;
    private final CsvTable columns;
    private final TreeMap<Integer, Row> known = new TreeMap<>(); // by run
    private final Manifest manifest;

    private SweepFolder(Path folder, Sweep sweep, Manifest manifest) throws IOException {
        this.folder = folder;
        this.manifest = manifest;
        this.columns = CsvTable.of(sweep);
        this.rows = FileChannel.open(
                folder.resolve(ROWS), StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
        try {
            if (!isOurs(rows)) {
                throw new InvalidSettings(
                        at(folder), "Another process is writing to it.", "Wait until that has ended.");
            }
            keepWholeRows();
            rows(folder).forEach(row -> known.put(row.run(), row));
            if (!known.isEmpty() && known.lastKey() > sweep.trials().size()) {
                throw new InvalidSettings(at(folder), "It has rows of runs that the sweep does not have.", "");
            }
            writeTable();
        } catch (IOException | RuntimeException e) {
            rows.close();
            throw e;
        }
    }

    /// Locks a byte behind all that will ever be there: on Windows, what is locked can't be read either, not even here.
    private static boolean isOurs(FileChannel rows) throws IOException {
        try {
            return rows.tryLock(Long.MAX_VALUE - 1, 1, false) != null;
        } catch (OverlappingFileLockException _) { // by this process
            return false;
        }
    }

    /// Makes the folder for a new experiment.
    ///
    /// @throws InvalidSettings when it has something in it
    /// @throws UncheckedIOException when it can't be written
    public static SweepFolder create(Path folder, Sweep sweep, Manifest.Session session) {
        try {
            if (Files.exists(folder.resolve(MANIFEST))) {
                throw new InvalidSettings(
                        at(folder),
                        "There is a sweep in it already.",
                        "Resume it by --resume, or name another folder.");
            }
            if (Files.exists(folder) && !isEmpty(folder)) {
                throw new InvalidSettings(at(folder), "The folder is not empty.", "Name one that is, or a new one.");
            }
            Files.createDirectories(folder);
            Manifest manifest = Manifest.of(sweep, session);
            replace(folder.resolve(MANIFEST), pretty(manifest));
            return new SweepFolder(folder, sweep, manifest);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// Opens a folder to go on with the experiment in it.
    ///
    /// @throws InvalidSettings when there is none, or another one
    /// @throws UncheckedIOException when it can't be written
    public static SweepFolder resume(Path folder, Sweep sweep, Manifest.Session session) {
        try {
            if (!Files.exists(folder.resolve(MANIFEST))) {
                throw new InvalidSettings(at(folder), "There is no sweep to resume.", "To start one, remove --resume.");
            }
            Manifest before = manifest(folder);
            List<String> differences = Manifest.Subject.of(sweep).differences(before.subject());
            if (!differences.isEmpty()) {
                throw new InvalidSettings(
                        at(folder),
                        "The sweep in it is another one. It differs in %s.".formatted(String.join("; ", differences)),
                        "Name another folder, or resume with the same command.");
            }
            Manifest manifest = before.with(session);
            var opened = new SweepFolder(folder, sweep, manifest);
            try {
                replace(folder.resolve(MANIFEST), pretty(manifest));
            } catch (IOException e) {
                opened.close();
                throw e;
            }
            return opened;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// What is there so far, by run.
    public synchronized List<Row> rows() {
        return List.copyOf(known.values());
    }

    /// What is known so far. Also once it is closed, or somebody has taken the folder away.
    public Findings findings() {
        return new Findings(manifest, rows());
    }

    /// Adds a row. Returns when it is on the disk.
    ///
    /// @throws UncheckedIOException when it can't be written; then nothing more should be
    synchronized void append(Row row) {
        if (known.containsKey(row.run())) {
            throw new IllegalStateException("Run '%d' has a row already.".formatted(row.run()));
        }
        try {
            write(rows, line(row));
            rows.force(false);
            known.put(row.run(), row);
            Files.writeString(folder.resolve(TABLE), columns.line(row), StandardOpenOption.APPEND);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// All rows are there: sorts the table.
    synchronized void complete() {
        try {
            writeTable();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    @Override
    public synchronized void close() {
        try {
            rows.close(); // gives up the lock, too
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /// Cuts off what a kill has left of a last row, and goes to the end.
    private void keepWholeRows() throws IOException {
        long end = wholeRows(Files.readAllBytes(folder.resolve(ROWS)));
        rows.truncate(end);
        rows.position(end);
        rows.force(true);
    }

    /// After how many bytes the last whole row ends. After a loss of power the last line may be there and not
    /// be a row.
    private static int wholeRows(byte[] all) {
        int end = lineEnd(all, all.length);
        int before = lineEnd(all, end - 1);
        return end == 0 || isRow(new String(all, before, end - before, StandardCharsets.UTF_8)) ? end : before;
    }

    private static int lineEnd(byte[] all, int before) {
        int end = before;
        while (end > 0 && all[end - 1] != '\n') {
            end--;
        }
        return Math.max(0, end);
    }

    private static boolean isRow(String line) {
        try {
            return JSON.readTree(line).isObject();
        } catch (JacksonException _) {
            return false;
        }
    }

    private void writeTable() throws IOException {
        replace(
                folder.resolve(TABLE),
                columns.header() + known.values().stream().map(columns::line).collect(Collectors.joining()));
    }

    static Manifest manifest(Path folder) {
        Path file = folder.resolve(MANIFEST);
        try {
            Manifest manifest = JSON.readValue(Files.readString(file), Manifest.class);
            if (manifest.format() != Manifest.FORMAT) {
                throw new InvalidSettings(
                        at(file),
                        "This sweep has format '%d'; this RSAL reads format %d."
                                .formatted(manifest.format(), Manifest.FORMAT),
                        manifest.format() > Manifest.FORMAT ? "It was made by a newer RSAL: use that." : "");
            }
            return manifest;
        } catch (IOException _) {
            throw new InvalidSettings(at(folder), "There is no sweep in it.", "'rsal sweep … --out DIR' makes one.");
        } catch (JacksonException | NullPointerException e) {
            throw new InvalidSettings(at(file), "This is not a manifest of a sweep: %s".formatted(firstLine(e)), "");
        }
    }

    /// @return in the order of the design; without what may be half a last row
    static List<Row> rows(Path folder) {
        Path file = folder.resolve(ROWS);
        var rows = new ArrayList<Row>();
        try {
            byte[] all = Files.exists(file) ? Files.readAllBytes(file) : new byte[0];
            String text = new String(all, 0, wholeRows(all), StandardCharsets.UTF_8);
            var runs = new HashSet<Integer>();
            int number = 0;
            for (String line : text.lines().toList()) {
                number++;
                Row row = read(line, new Location(file.toString(), number, 1));
                if (!runs.add(row.run())) {
                    throw new InvalidSettings(
                            new Location(file.toString(), number, 1),
                            "Run '%d' is there twice.".formatted(row.run()),
                            "");
                }
                rows.add(row);
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        rows.sort(Comparator.comparingInt(Row::run));
        return rows;
    }

    /// How many lines are whole.
    static long countRows(Path folder) {
        Path file = folder.resolve(ROWS);
        if (!Files.exists(file)) {
            return 0;
        }
        var part = new byte[BLOCK];
        long count = 0;
        try (var rows = Files.newInputStream(file)) {
            for (int length = rows.read(part); length >= 0; length = rows.read(part)) {
                for (int i = 0; i < length; i++) {
                    count += part[i] == '\n' ? 1 : 0;
                }
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return count;
    }

    private static Row read(String line, Location at) {
        try {
            return JSON.readValue(line, Row.class);
        } catch (JacksonException | NullPointerException e) {
            throw new InvalidSettings(at, "This is not a row of a sweep: %s".formatted(firstLine(e)), "");
        }
    }

    private static String firstLine(RuntimeException e) {
        return String.valueOf(e.getMessage()).lines().findFirst().orElse("");
    }

    private static String line(Row row) {
        return JSON.writeValueAsString(row) + "\n";
    }

    private static String pretty(Manifest manifest) {
        return JSON.writer(SerializationFeature.INDENT_OUTPUT).writeValueAsString(manifest) + "\n";
    }

    /// Nobody ever sees half of the file.
    private static void replace(Path file, String text) throws IOException {
        Path part = file.resolveSibling(file.getFileName() + PART);
        try (var channel = FileChannel.open(
                part, StandardOpenOption.CREATE, StandardOpenOption.WRITE, StandardOpenOption.TRUNCATE_EXISTING)) {
            write(channel, text);
            channel.force(true);
        }
        Files.move(part, file, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    }

    private static void write(FileChannel channel, String text) throws IOException {
        ByteBuffer bytes = ByteBuffer.wrap(text.getBytes(StandardCharsets.UTF_8));
        while (bytes.hasRemaining()) {
            channel.write(bytes);
        }
    }

    /// But for what a sweep leaves that was killed before it had begun.
    private static boolean isEmpty(Path folder) throws IOException {
        try (var files = Files.list(folder)) {
            return files.allMatch(file -> file.endsWith(MANIFEST + PART));
        }
    }

    private static Location at(Path path) {
        return Location.of(path.toString());
    }
}
