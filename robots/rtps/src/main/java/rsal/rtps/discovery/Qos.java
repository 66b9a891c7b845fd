package rsal.rtps.discovery;

import java.util.Optional;
import rsal.rtps.wire.Timestamp;

/// How a writer or reader wants its samples to come: its quality of service.
///
/// @param isReliable whether lost samples are sent again; best effort otherwise
/// @param isLatched whether a late reader gets the samples that were written before it: durability *transient
///     local*, *volatile* otherwise
/// @param depth how many samples are kept (keep last); [#KEEP_ALL] for all that some reader lacks: then a
///     reliable writer waits for room
/// @param deadline [ns] between samples, offered by a writer and wanted by a reader
/// @param liveliness of a writer, or wanted
public record Qos(boolean isReliable, boolean isLatched, int depth, long deadline, Liveliness liveliness) {
    public static final int KEEP_ALL = Integer.MAX_VALUE;

    /// For how long a writer that keeps all waits for room [ns], as is usual for DDS.
    public static final long MAX_BLOCKING = 100_000_000;

    /// ROS's profile for topics: reliable, volatile, the last 10.
    public static final Qos DEFAULT =
            new Qos(true, false, 10, Timestamp.INFINITE, new Liveliness(Liveliness.AUTOMATIC, Timestamp.INFINITE));

    /// ROS's profile for sensor data: best effort, volatile, the last 5.
    public static final Qos SENSOR_DATA = DEFAULT.bestEffort().keep(5);

    /// For maps and all else that a late reader needs: reliable, transient local, the last one.
    public static final Qos LATCHED = DEFAULT.latched().keep(1);

    /// @param kind how a writer shows that it lives
    /// @param lease [ns] within which it does
    public record Liveliness(int kind, long lease) {
        public static final int AUTOMATIC = 0;
    }

    public Qos bestEffort() {
        return new Qos(false, isLatched, depth, deadline, liveliness);
    }

    public Qos latched() {
        return new Qos(isReliable, true, depth, deadline, liveliness);
    }

    public Qos keep(int last) {
        return new Qos(isReliable, isLatched, last, deadline, liveliness);
    }

    /// Why a writer that offers this does not serve a reader; empty when it does (DDS 1.4, table 2.2.3: offered must
    /// be at least what is requested).
    public Optional<String> mismatch(Qos requested) {
        if (requested.isReliable && !isReliable) {
            return Optional.of("reliability: the reader wants reliable, the writer offers best effort");
        }
        if (requested.isLatched && !isLatched) {
            return Optional.of("durability: the reader wants transient local, the writer offers volatile");
        }
        if (deadline > requested.deadline) {
            return Optional.of("deadline: the reader wants samples more often than the writer offers");
        }
        if (liveliness.kind < requested.liveliness.kind || liveliness.lease > requested.liveliness.lease) {
            return Optional.of("liveliness: the reader wants more than the writer offers");
        }
        return Optional.empty();
    }
}
