package rsal.navigation.log;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import java.util.ServiceLoader;

/// The formats of logs that are installed.
public final class LogFormats {
    private static final String PACKED = ".gz";

    private LogFormats() {}

    /// All of them, by suffix.
    public static List<LogFormat> installed() {
        return ServiceLoader.load(LogFormat.class).stream()
                .map(ServiceLoader.Provider::get)
                .sorted(Comparator.comparing(LogFormat::suffix))
                .toList();
    }

    /// Reads a log by the format with the longest suffix that its name ends with.
    ///
    /// @throws BrokenLog when the file is cut short, damaged, too large or no log
    /// @throws IOException when the file can't be read
    public static RobotLog read(Path file, LaserHints hints) throws IOException {
        LogFormat format = of(file.toString());
        try (InputStream in = Files.newInputStream(file)) {
            return read(format, file.toString(), in, hints);
        }
    }

    /// @param file its name, for messages
    public static RobotLog read(LogFormat format, String file, InputStream in, LaserHints hints) throws IOException {
        var log = new LogCollector(file, hints);
        format.read(file, in, hints, log);
        return log.log();
    }

    private static LogFormat of(String file) {
        String name = file.toLowerCase(Locale.ROOT);
        String plain = name.endsWith(PACKED) ? name.substring(0, name.length() - PACKED.length()) : name;
        return installed().stream()
                .filter(format -> plain.endsWith(format.suffix().toLowerCase(Locale.ROOT)))
                .max(Comparator.comparingInt(format -> format.suffix().length()))
                .orElseThrow(() -> new IllegalStateException("No format of logs is installed."));
    }
}
