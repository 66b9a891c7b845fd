package rsal.navigation.log;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/// A format of logs of a robot's laser and odometry. Found by [java.util.ServiceLoader]; an implementation has no
/// state and may be called on any thread.
public interface LogFormat {
    /// How names of its files end, as `.csv`. Files that are packed with gzip have `.gz` behind it, with Zstd
    /// `.zstd` or `.zst`; the format unpacks them ([LogLines] does gzip). Empty for the format of all files that no
    /// other one reads, which is CARMEN's.
    String suffix();

    /// What its files hold, in a sentence for people.
    String description();

    /// Reads a log.
    ///
    /// @param file its name, for messages
    /// @param in the file as it is, packed or not: [LogLines] reads both. The caller closes it
    /// @param hints what is known of the laser
    /// @param log takes what was read, in the order of the file, and what was skipped
    /// @throws BrokenLog when the file is cut short, damaged, too large or of another kind
    /// @throws IOException when the file can't be read
    void read(String file, InputStream in, LaserHints hints, LogCollector log) throws IOException;

    /// Writes logs in this format; empty for one that is only read.
    default Optional<LogWriter> writer() {
        return Optional.empty();
    }

    /// Reads a log from its file, or from the folder that has it. Formats that are read by an index, not from the
    /// beginning to the end, do that here.
    ///
    /// @throws BrokenLog as above
    /// @throws IOException when the file can't be read
    default void read(Path file, LaserHints hints, LogCollector log) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            read(file.toString(), in, hints, log);
        }
    }
}
