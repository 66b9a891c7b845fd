package rsal.navigation.carmen;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import rsal.data.LaserScan;
import rsal.navigation.carmen.LogEntry.Motion;
import rsal.navigation.carmen.LogEntry.Scan;

/// A whole log in memory: at most [#MOST_READINGS] readings.
///
/// @param scans in the order of the file, times never going back but where the clock was
/// @param motions likewise
/// @param skipped what was not used
/// @param rangeMax from here on readings hit nothing [m], as the log itself shows it or the reader was told
public record CarmenLog(
        List<Scan> scans, List<Motion> motions, List<LogEntry.Parameter> parameters, Skipped skipped, double rangeMax) {
    /// 400 MB of ranges; the longest public logs have a tenth of this.
    public static final int MOST_READINGS = 100_000_000;

    private static final int MOST_MOTIONS = 20_000_000;
    private static final int MOST_PARAMETERS = 100_000;
    private static final double SAME = 0.1; // m; codes for nothing differ by less
    private static final double SHARE_OF_CODES = 2e-3; // of all readings
    private static final double BELOW = 0.5; // m; so far below codes there are fewer readings than codes

    public CarmenLog {
        scans = List.copyOf(scans);
        motions = List.copyOf(motions);
        parameters = List.copyOf(parameters);
    }

    /// @throws BrokenLog when the file is cut short, damaged, too large or no log
    /// @throws IOException when the file can't be read
    public static CarmenLog read(Path file, LogReader.Options options) throws IOException {
        try (InputStream in = Files.newInputStream(file)) {
            return read(file.toString(), in, options);
        }
    }

    /// @param file its name, for messages
    public static CarmenLog read(String file, InputStream in, LogReader.Options options) throws IOException {
        var reading = new Reading();
        Skipped skipped;
        try {
            skipped = LogReader.read(file, in, options, reading::add);
        } catch (TooMuch e) {
            throw new BrokenLog(
                    file,
                    e.line,
                    "The log has more %s than can be held (%d). Cut it into parts.".formatted(e.what, e.most));
        }
        double rangeMax = Math.min(options.rangeMax(), longest(reading.scans));
        List<Scan> scans = rangeMax < options.rangeMax()
                ? reading.scans.stream().map(scan -> limited(scan, rangeMax)).toList()
                : reading.scans;
        return new CarmenLog(scans, reading.motions, reading.parameters, skipped, rangeMax);
    }

    /// Where the longest readings of the log lie when they are so many, so equal and so far from others that they
    /// must be what the laser says for nothing; +∞ otherwise: the far corner of a room has walls that lead to it.
    /// Drivers write 8.0, 29.9 and more.
    private static double longest(List<Scan> scans) {
        float most = 0;
        long readings = 0;
        for (Scan scan : scans) {
            readings += scan.scan().count();
            for (float range : scan.scan().ranges()) {
                most = range < Float.POSITIVE_INFINITY ? Math.max(most, range) : most;
            }
        }
        long codes = 0;
        long below = 0;
        for (Scan scan : scans) {
            for (float range : scan.scan().ranges()) {
                codes += range >= most - SAME && range <= most ? 1 : 0;
                below += range >= most - SAME - BELOW && range < most - SAME ? 1 : 0;
            }
        }
        return codes > 100 && codes > SHARE_OF_CODES * readings && codes > 2 * below
                ? most - SAME
                : Double.POSITIVE_INFINITY;
    }

    private static Scan limited(Scan entry, double rangeMax) {
        LaserScan scan = entry.scan();
        var ranges = scan.ranges().clone();
        for (int i = 0; i < ranges.length; i++) {
            ranges[i] = ranges[i] >= rangeMax ? Float.POSITIVE_INFINITY : ranges[i];
        }
        return new Scan(
                entry.line(),
                entry.time(),
                new LaserScan(
                        scan.baseFromLaser(),
                        scan.angleMin(),
                        scan.angleIncrement(),
                        scan.rangeMin(),
                        Math.min(scan.rangeMax(), rangeMax),
                        ranges),
                entry.poses(),
                entry.broken());
    }

    private static final class TooMuch extends RuntimeException {
        private static final long serialVersionUID = 1;
        private final int line;
        private final String what;
        private final int most;

        TooMuch(int line, String what, int most) {
            super(what);
            this.line = line;
            this.what = what;
            this.most = most;
        }
    }

    private static final class Reading {
        private final List<Scan> scans = new ArrayList<>();
        private final List<Motion> motions = new ArrayList<>();
        private final List<LogEntry.Parameter> parameters = new ArrayList<>();
        private long readings;

        void add(LogEntry entry) {
            switch (entry) {
                case Scan scan -> {
                    readings += scan.scan().count();
                    if (readings > MOST_READINGS) {
                        throw new TooMuch(scan.line(), "readings", MOST_READINGS);
                    }
                    scans.add(scan);
                }
                case Motion motion -> add(motions, motion, "odometry", MOST_MOTIONS);
                case LogEntry.Parameter parameter -> add(parameters, parameter, "parameters", MOST_PARAMETERS);
            }
        }

        private static <E extends LogEntry> void add(List<E> into, E entry, String what, int most) {
            if (into.size() == most) {
                throw new TooMuch(entry.line(), what, most);
            }
            into.add(entry);
        }
    }
}
