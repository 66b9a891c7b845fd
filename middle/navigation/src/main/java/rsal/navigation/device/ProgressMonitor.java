package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import rsal.data.Pose2d;
import rsal.navigation.control.ProgressChecker;

/// Whether a robot makes progress to its goal, for how long it does not, and when it is time to give up.
final class ProgressMonitor {
    private static final double NEARER = 0.1; // m or rad; less does not count against the patience
    private static final int MOST_STALLS = 3; // by what it does not see, without getting on meanwhile
    private static final double GOT_ON = 1; // m

    private final ProgressChecker checker;
    private final Duration patience;
    private Instant since; // when it last made progress, or a recovery ended
    private Pose2d mapFromProgress = Pose2d.ORIGIN; // where it was then
    private int tried; // recoveries since it made progress
    private double least = Double.POSITIVE_INFINITY; // that was ever left
    private Instant giveUp;
    private int stalls; // since it got on
    private double leftAtStall = Double.POSITIVE_INFINITY; // least that was left at one of these

    ProgressMonitor(ProgressChecker checker, Duration patience, Instant now) {
        this.checker = checker;
        this.patience = patience;
        this.since = now;
        this.giveUp = now.plus(patience);
    }

    /// Goes on where that of a former goal is.
    void succeed(ProgressMonitor old, double left) {
        since = old.since;
        checker.onNewPath(left);
    }

    /// @param left of the path, or of the turn at its end, as [ProgressChecker#isProgress] has it
    void see(Instant now, Pose2d mapFromBase, double left) {
        if (checker.isProgress(mapFromBase, left)) {
            begin(now, mapFromBase);
            tried = 0;
        }
        if (left < least - NEARER) {
            least = left;
            giveUp = now.plus(patience);
        }
    }

    /// The robot begins to move freely here.
    void begin(Instant now, Pose2d mapFromBase) {
        since = now;
        mapFromProgress = mapFromBase;
    }

    /// It is here, but has no path yet.
    void standsAt(Pose2d mapFromBase) {
        mapFromProgress = mapFromBase;
    }

    /// Nothing holds it up now.
    void excuse(Instant now) {
        since = now;
    }

    /// Time that passed until now does not count.
    void resume(Instant now) {
        since = now;
        giveUp = now.plus(patience);
    }

    void onNewPath(double left) {
        checker.onNewPath(left);
    }

    /// What was left before says nothing of the path that it has now, for which it has all its patience.
    void beginAgain(Instant now, double left) {
        least = left;
        leftAtStall = left;
        giveUp = now.plus(patience);
    }

    void onRecovery() {
        tried++;
    }

    /// Notes that it stalls, and says whether it did so too often.
    boolean stallsTooOften(double left) {
        stalls = left < leftAtStall - GOT_ON ? 1 : stalls + 1;
        leftAtStall = Math.min(left, leftAtStall);
        return stalls >= MOST_STALLS;
    }

    boolean isTimeToGiveUp(Instant now) {
        return now.isAfter(giveUp);
    }

    /// Whether anything was ever left.
    boolean hasBegun() {
        return least < Double.POSITIVE_INFINITY;
    }

    Duration withoutProgress(Instant now) {
        return Duration.between(since, now);
    }

    Pose2d mapFromProgress() {
        return mapFromProgress;
    }

    int tried() {
        return tried;
    }

    int stalls() {
        return stalls;
    }
}
