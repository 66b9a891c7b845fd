package rsal.navigation.log;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import rsal.navigation.log.LogEntry.Motion;
import rsal.navigation.log.LogEntry.Scan;

/// Takes what a [LogFormat] reads, as far as memory allows, and makes a [RobotLog] of it. Of one thread.
public final class LogCollector {
    private static final int MOST_MOTIONS = 20_000_000;
    private static final int MOST_PARAMETERS = 100_000;

    private final String file;
    private final LaserHints hints;
    private final List<Scan> scans = new ArrayList<>();
    private final List<Motion> motions = new ArrayList<>();
    private final List<LogEntry.Parameter> parameters = new ArrayList<>();
    private final Map<String, Integer> skipped = new LinkedHashMap<>(); // messages by reason
    private final List<Skipped.Place> firstSkipped = new ArrayList<>();
    private int skippedScans;
    private int otherKinds;
    private long ranges;
    private OptionalDouble degrees = OptionalDouble.empty();
    private Optional<RobotLog.ScanTopic> topic = Optional.empty();

    /// @param file its name, for messages
    /// @param hints whether the laser is upside down, and from where on ranges hit nothing
    public LogCollector(String file, LaserHints hints) {
        this.file = file;
        this.hints = hints;
    }

    /// Takes a message. The ranges of a scan go counter-clockwise, as if the laser were not upside down.
    ///
    /// @throws BrokenLog when the log has more than can be held
    public void add(LogEntry entry) throws BrokenLog {
        switch (entry) {
            case Scan scan -> {
                ranges += scan.scan().count();
                if (ranges > RobotLog.MOST_READINGS) {
                    throw tooMuch(scan, "readings", RobotLog.MOST_READINGS);
                }
                scans.add(hints.upsideDown() ? scan.with(scan.scan().mirrored()) : scan);
            }
            case Motion motion -> add(motions, motion, "odometry", MOST_MOTIONS);
            case LogEntry.Parameter parameter -> add(parameters, parameter, "parameters", MOST_PARAMETERS);
        }
    }

    private <E extends LogEntry> void add(List<E> into, E entry, String what, int most) throws BrokenLog {
        if (into.size() == most) {
            throw tooMuch(entry, what, most);
        }
        into.add(entry);
    }

    private BrokenLog tooMuch(LogEntry entry, String what, int most) {
        return new BrokenLog(
                file,
                entry.line(),
                "The log has more %s than can be held (%d). Cut it into parts.".formatted(what, most));
    }

    /// Counts a message that cannot be used.
    ///
    /// @param line where it stands, from 1
    /// @param reason in a few words that are the same for all such messages, as `cut short`
    /// @param what is wrong with this one, with its value, in a sentence
    /// @param isScan whether it was a scan
    public void skip(int line, String reason, String what, boolean isScan) {
        skipped.merge(reason, 1, Integer::sum);
        skippedScans += isScan ? 1 : 0;
        if (firstSkipped.size() < Skipped.TOLD) {
            firstSkipped.add(new Skipped.Place(line, what));
        }
    }

    /// Counts a line of a kind that is not read, as a comment.
    public void passOver() {
        otherKinds++;
    }

    /// Whether nothing at all was added or skipped.
    public boolean isEmpty() {
        return scans.isEmpty() && motions.isEmpty() && parameters.isEmpty() && skipped.isEmpty();
    }

    /// Says that the headings are probably degrees, though they were read as radians.
    ///
    /// @param most the largest of them
    public void headingsAreProbablyDegrees(double most) {
        degrees = OptionalDouble.of(most);
    }

    /// Says which topic the scans are of, in a log that has topics.
    ///
    /// @param others topics of scans that are not read
    public void scansAreOf(String topic, List<String> others) {
        this.topic = Optional.of(new RobotLog.ScanTopic(topic, others));
    }

    /// What was collected.
    public RobotLog log() {
        return RobotLog.of(
                scans,
                motions,
                parameters,
                new Skipped(skipped, skippedScans, firstSkipped, otherKinds),
                hints.rangeMax(),
                degrees,
                topic);
    }
}
