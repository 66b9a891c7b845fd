package rsal.engine.metric;

import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.engine.robot.RobotPoses;
import rsal.metric.SignalType;
import rsal.scenario.condition.RunQuantities;

/// What there is to measure of one robot.
final class RobotRecord {
    private static final int HISTORY = 64; // steps that a localizer may be late

    private final String role;
    private final Deque<Truth> history = new ArrayDeque<>(); // newest first
    private final Map<String, Samples> samples = new HashMap<>(); // by word of the signal
    private @Nullable Instant compared;
    private double distance;
    private boolean seen;

    RobotRecord(String role) {
        this.role = role;
    }

    String role() {
        return role;
    }

    /// @param asked empty for any
    boolean hasRole(Optional<String> asked) {
        return asked.isEmpty() || asked.get().equals(role);
    }

    /// Where it really is now.
    void moved(Instant now, Pose2d mapFromBase) {
        if (!history.isEmpty()) {
            distance += history.getFirst().mapFromBase.distanceTo(mapFromBase);
        }
        seen = true;
        history.addFirst(new Truth(now, mapFromBase));
        if (history.size() > HISTORY) {
            history.removeLast();
        }
    }

    /// Somebody is going to put it elsewhere: that way does not count.
    void placed() {
        history.clear();
    }

    /// Compares a localizer's reading, unless that is done, with the truth at its time.
    ///
    /// @param now since the run's start, as below [s]
    void compare(Stamped<PoseEstimate> estimate, double now) {
        if (estimate.time().equals(compared)) {
            return;
        }
        compared = estimate.time();
        if (!estimate.frame().equals(RobotPoses.WORLD)) {
            return; // nobody knows how its own map lies in the world
        }
        for (Iterator<Truth> truths = history.iterator(); truths.hasNext(); ) {
            Truth truth = truths.next();
            if (!truth.time.isAfter(estimate.time())) {
                sample(
                        RunQuantities.POSE_ERROR,
                        truth.mapFromBase.distanceTo(estimate.value().mapFromBase()),
                        now);
                return;
            }
        }
    }

    void sample(SignalType signal, double value, double now) {
        samples.computeIfAbsent(signal.word(), _ -> new Samples()).add(now, value);
    }

    /// Share of the battery that is left; NaN when the battery can't tell.
    void charged(double level, double now) {
        if (!Double.isNaN(level)) {
            sample(RunQuantities.BATTERY_LEVEL, level, now);
        }
    }

    /// The way it really made [m].
    double distance() {
        return distance;
    }

    /// Whether there is a truth at all.
    boolean seen() {
        return seen;
    }

    Samples samples(SignalType signal) {
        return samples.getOrDefault(signal.word(), new Samples());
    }

    private record Truth(Instant time, Pose2d mapFromBase) {}
}
