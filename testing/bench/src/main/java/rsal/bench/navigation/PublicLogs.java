package rsal.bench.navigation;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.navigation.log.LaserHints;
import rsal.navigation.log.LogFormats;
import rsal.navigation.replay.RecordedDrive;

/// Recorded logs among the public data, with the poses that their authors found to be right.
final class PublicLogs {
    static final List<String> NAMES =
            List.of("acapulco", "aces", "edmonton", "fhw", "freiburg-101", "orebro", "seattle");

    private PublicLogs() {}

    /// What a log is called in names of measurements.
    static String label(String log) {
        return log.replace("-", "");
    }

    /// A log's course; empty when it is not among the data.
    static Optional<RecordedDrive> drive(String log, BenchmarkRequest assignment) {
        return assignment.data("logs/%s-corrected.log.gz".formatted(log)).map(PublicLogs::read);
    }

    private static RecordedDrive read(Path file) {
        try {
            return RecordedDrive.of(LogFormats.read(file, LaserHints.DEFAULT));
        } catch (IOException e) {
            throw new IllegalStateException("The public data can't be read: " + e.getMessage(), e);
        }
    }
}
