package rsal.ros2.tf;

import java.util.Map;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import rsal.ros2.message.FrameTransform;

/// Where one frame was in its parents. A frame that never moves is there at all times.
final class FrameHistory {
    private final NavigableMap<Long, Placed> samples = new TreeMap<>(); // by stamp; none while it is fixed
    private Optional<Placed> fixed = Optional.empty();

    /// Where it is in a parent.
    record Placed(String parent, FrameTransform parentFromFrame) {}

    void fix(Placed placed) {
        samples.clear();
        fixed = Optional.of(placed);
    }

    /// @param stamp which replaces what is there
    void put(long stamp, Placed placed) {
        fixed = Optional.empty();
        samples.put(stamp, placed);
    }

    boolean isFixed() {
        return fixed.isPresent();
    }

    int count() {
        return samples.size();
    }

    /// Takes all samples away that are older.
    void dropBefore(long stamp) {
        samples.headMap(stamp, false).clear();
    }

    void dropOldest() {
        samples.pollFirstEntry();
    }

    /// The stamp of the first sample; of a frame that moves.
    long oldest() {
        return samples.firstKey();
    }

    /// The stamp of the last sample; of a frame that moves.
    long newest() {
        return samples.lastKey();
    }

    /// The last sample.
    Placed last() {
        return fixed.orElseGet(() -> samples.lastEntry().getValue());
    }

    /// Where it was, between two samples by interpolation; empty before the first and after the last one. Where its
    /// parent changed in between, the earlier sample holds until the later one, as in tf2.
    Optional<Placed> at(long stamp) {
        if (fixed.isPresent()) {
            return fixed;
        }
        Map.Entry<Long, Placed> before = samples.floorEntry(stamp);
        Map.Entry<Long, Placed> after = samples.ceilingEntry(stamp);
        return before == null || after == null ? Optional.empty() : Optional.of(between(before, after, stamp));
    }

    private static Placed between(Map.Entry<Long, Placed> before, Map.Entry<Long, Placed> after, long stamp) {
        Placed from = before.getValue();
        Placed to = after.getValue();
        long span = after.getKey() - before.getKey();
        if (span == 0 || !from.parent.equals(to.parent)) {
            return from;
        }
        double share = (double) (stamp - before.getKey()) / span;
        return new Placed(from.parent, from.parentFromFrame.interpolated(to.parentFromFrame, share));
    }
}
