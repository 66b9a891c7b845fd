package rsal.navigation.log;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.ServiceLoader;
import java.util.stream.Stream;

/// The formats of logs that are installed.
public final class LogFormats {
    private static final List<String> PACKED = List.of(".gz", ".zstd", ".zst");

    private LogFormats() {}

    /// All of them, by suffix.
    public static List<LogFormat> installed() {
        return ServiceLoader.load(LogFormat.class).stream()
                .map(ServiceLoader.Provider::get)
                .sorted(Comparator.comparing(LogFormat::suffix))
                .toList();
    }

    /// Those that can be written, in the same order.
    public static List<LogWriter> writers() {
        return installed().stream().flatMap(format -> format.writer().stream()).toList();
    }

    /// Reads a log by the format with the longest suffix that its name ends with; of a folder, that the name of a
    /// file in it ends with.
    ///
    /// @throws BrokenLog when the file is cut short, damaged, too large or no log
    /// @throws IOException when the file can't be read
    public static RobotLog read(Path file, LaserHints hints) throws IOException {
        var log = new LogCollector(file.toString(), hints);
        of(file).read(file, hints, log);
        return log.log();
    }

    /// @param file its name, for messages
    public static RobotLog read(LogFormat format, String file, InputStream in, LaserHints hints) throws IOException {
        var log = new LogCollector(file, hints);
        format.read(file, in, hints, log);
        return log.log();
    }

    private static LogFormat of(Path file) throws IOException {
        if (!Files.isDirectory(file)) {
            return of(file.toString());
        }
        try (Stream<Path> files = Files.list(file)) {
            return files.map(Path::toString)
                    .sorted()
                    .map(LogFormats::of)
                    .filter(format -> !format.suffix().isEmpty())
                    .findFirst()
                    .orElseThrow(() -> new BrokenLog(file.toString(), 0, "There is no log in this folder."));
        }
    }

    private static LogFormat of(String file) {
        String name = file.toLowerCase(Locale.ROOT);
        String plain = PACKED.stream()
                .filter(name::endsWith)
                .findFirst()
                .map(ending -> name.substring(0, name.length() - ending.length()))
                .orElse(name);
        return installed().stream()
                .filter(format -> plain.endsWith(format.suffix().toLowerCase(Locale.ROOT)))
                .max(Comparator.comparingInt(format -> format.suffix().length()))
                .orElseThrow(() -> new IllegalStateException("No format of logs is installed."));
    }
}
