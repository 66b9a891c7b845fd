package rsal.cli.terminal;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/// Logs of internal errors, in the folder for temporary files: the newest few are kept.
public final class OldLogs {
    private static final int KEPT = 10;

    private OldLogs() {}

    /// A new log, which only its owner may read. Older ones go.
    public static Path next() throws IOException {
        Path log = Files.createTempFile("rsal-", ".log");
        Path folder = log.toAbsolutePath().getParent();
        if (folder != null) {
            keepNewest(folder, KEPT);
        }
        return log;
    }

    /// Deletes all but the newest logs of a folder. Those that can't be deleted, as somebody else's, stay.
    static void keepNewest(Path folder, int kept) throws IOException {
        List<Path> all;
        try (Stream<Path> files = Files.list(folder)) {
            all = files.filter(file -> String.valueOf(file.getFileName()).matches("rsal-\\d+\\.log"))
                    .filter(OldLogs::isOurs)
                    .sorted(Comparator.comparingLong(OldLogs::written).reversed())
                    .toList();
        }
        for (Path old : all.subList(Math.min(kept, all.size()), all.size())) {
            try {
                Files.deleteIfExists(old);
            } catch (IOException _) {
                // it stays
            }
        }
    }

    private static boolean isOurs(Path file) {
        try {
            return Files.isRegularFile(file) && Files.getOwner(file).getName().equals(System.getProperty("user.name"));
        } catch (IOException _) {
            return false;
        }
    }

    /// When it was written, in ms.
    private static long written(Path file) {
        return file.toFile().lastModified();
    }
}
