package rsal.ros2.bag;

import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.mcap.InvalidMcap;
import rsal.navigation.log.BrokenLog;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogCollector;
import rsal.ros2.bag.SqliteBag.NoBag;
import rsal.ros2.sqlite.InvalidSqlite;

/// The files of a bag, in the order of their numbers: `run_0.mcap`, …, `run_10.mcap`. Those that are compressed as a
/// whole are decompressed to files of their own, which are deleted at the end.
final class BagFiles implements Closeable {
    static final String MCAP = ".mcap";
    static final String SQLITE = ".db3";

    private static final List<String> PACKED = List.of(".zstd", ".zst");
    private static final Comparator<String> BY_NUMBER =
            Comparator.comparingInt(String::length).thenComparing(Comparator.naturalOrder());

    private final String name;
    private final List<Path> files = new ArrayList<>(); // decompressed
    private final List<Path> copies = new ArrayList<>(); // those of them that are temporary

    /// @param name of the bag, for messages
    private BagFiles(String name) {
        this.name = name;
    }

    /// @param bag a file, or the folder of a bag
    static BagFiles at(Path bag) throws IOException {
        var opened = new BagFiles(bag.toString());
        try {
            for (Path file : Files.isDirectory(bag) ? opened.parts(bag) : List.of(bag)) {
                opened.add(file);
            }
            return opened;
        } catch (IOException | RuntimeException e) {
            opened.close();
            throw e;
        }
    }

    /// A bag of one file that comes as a stream, whose length is unknown.
    ///
    /// @param name of the file; its ending says what it is
    static BagFiles copy(String name, InputStream in) throws IOException {
        var opened = new BagFiles(name);
        try {
            Path copy = opened.room(name);
            Files.copy(in, copy, StandardCopyOption.REPLACE_EXISTING);
            if (plain(name).equals(name)) {
                opened.files.add(copy);
            } else {
                opened.decompress(copy, name);
            }
            return opened;
        } catch (IOException | RuntimeException e) {
            opened.close();
            throw e;
        }
    }

    private void add(Path file) throws IOException {
        if (plain(file.toString()).equals(file.toString())) {
            files.add(file);
        } else {
            decompress(file, file.toString());
        }
    }

    private void decompress(Path file, String named) throws IOException {
        Path copy = room(plain(named));
        try (InputStream in = Files.newInputStream(file)) {
            ZstdData.decompress(named, in, Files.size(file), copy);
        }
        files.add(copy);
    }

    private Path room(String named) throws IOException {
        Path copy = Files.createTempFile("rsal-bag-", isSqlite(named) ? SQLITE : MCAP);
        copies.add(copy);
        return copy;
    }

    /// Players of ROS decompress files beside the compressed ones; these count once.
    private List<Path> parts(Path folder) throws IOException {
        Set<String> names;
        try (Stream<Path> list = Files.list(folder)) {
            names = list.map(file -> String.valueOf(file.getFileName())).collect(Collectors.toSet());
        }
        List<String> parts = names.stream()
                .filter(file -> plain(file).equals(file) || !names.contains(plain(file)))
                .filter(file ->
                        isSqlite(file) || plain(file).toLowerCase(Locale.ROOT).endsWith(MCAP))
                .sorted(BY_NUMBER)
                .toList();
        if (parts.stream().map(BagFiles::isSqlite).distinct().count() > 1) {
            throw new BrokenLog(name, 0, "This folder has files in MCAP and in sqlite3. Name the file to be read.");
        }
        return parts.stream().map(folder::resolve).toList();
    }

    private static boolean isSqlite(String file) {
        return plain(file).toLowerCase(Locale.ROOT).endsWith(SQLITE);
    }

    /// Its name before it was compressed.
    private static String plain(String file) {
        return PACKED.stream()
                .filter(ending -> file.toLowerCase(Locale.ROOT).endsWith(ending))
                .findFirst()
                .map(ending -> file.substring(0, file.length() - ending.length()))
                .orElse(file);
    }

    /// Reads all files: twice, as where frames are on the robot may stand anywhere.
    ///
    /// @throws BrokenLog when one is not a bag, or there are no scans
    void read(LaserHints hints, LogCollector log) throws IOException {
        var reader = new BagReader(name, hints, log);
        try {
            for (Path file : files) {
                try (BagFile bag = open(file)) {
                    reader.readFrames(bag);
                }
            }
            for (Path file : files) {
                try (BagFile bag = open(file)) {
                    reader.readScans(bag);
                }
            }
        } catch (InvalidMcap | InvalidSqlite | NoBag e) {
            throw new BrokenLog(name, 0, String.valueOf(e.getMessage()), e);
        }
        reader.end();
    }

    private static BagFile open(Path file) throws IOException {
        return isSqlite(file.toString()) ? new SqliteBag(file) : new McapBag(file);
    }

    @Override
    public void close() throws IOException {
        for (Path copy : copies) {
            Files.deleteIfExists(copy);
        }
    }
}
