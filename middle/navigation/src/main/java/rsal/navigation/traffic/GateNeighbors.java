package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.Passage;
import rsal.navigation.passage.Passages;
import rsal.navigation.traffic.Mates.Mate;
import rsal.navigation.traffic.TrafficReport.Claim;

/// Where other robots are at the passages of a claim.
final class GateNeighbors {
    private static final Duration LEFT = Duration.ofSeconds(2); // without moving; then it stands there
    private static final double SAME_GATE = 1.0; // m between what two robots take for one gate
    private static final double BEHIND = 0.6; // m between a follower and the one before it

    private final Mates mates;
    private final TrafficType.Participant self;
    private @Nullable Passages passages;
    private Pose2d mapFromBase = Pose2d.ORIGIN;
    private Instant now;

    GateNeighbors(Mates mates, TrafficType.Participant self) {
        this.mates = mates;
        this.self = self;
        this.now = self.start();
    }

    /// The robot is there now.
    void see(Instant at, Pose2d pose, @Nullable Passages known) {
        now = at;
        mapFromBase = pose;
        passages = known;
    }

    /// Whether somebody that comes out still drives where this robot is to approach the gate.
    boolean isSomebodyLeaving(OwnClaim wanted) {
        Point2d place = mapFromBase.position();
        double own = place.distanceTo(wanted.entry);
        Point2d door = wanted.passages().getFirst().nearest(place);
        for (Mate mate : mates.all()) {
            Point2d other = mate.report.mapFromBase().position();
            boolean isBetween = other.distanceTo(wanted.entry) < own + self.radius()
                    && WaitingChoice.distance(other, place, door) < 2 * self.radius();
            boolean comesAfter =
                    mate.report.claim().filter(claimed -> !claimed.isHeld()).isPresent();
            if (isBetween && !comesAfter && mate.still(now).compareTo(LEFT) < 0) {
                return true;
            }
        }
        return false;
    }

    /// Whether those that a follower goes behind are nearer to the gate, or through it.
    boolean isBehindLeader(OwnClaim wanted) {
        double own = mapFromBase.position().distanceTo(wanted.entry);
        for (Mate mate : mates.all()) {
            Claim other = mate.report.claim().orElse(null);
            if (other != null
                    && other.isHeld()
                    && meets(wanted, other.passages())
                    && isSame(other.entry(), wanted.entry)) {
                Point2d place = mate.report.mapFromBase().position();
                boolean isInside = passages != null && passages.index(place.x(), place.y()) >= 0;
                if (!isInside && place.distanceTo(wanted.entry) > own - self.radius()) {
                    return false;
                }
            }
        }
        return true;
    }

    /// Whether a robot that goes through in the same direction is just ahead. Its follower stops, and neither looks for
    /// a path around it nor turns away: nothing is wrong.
    boolean isTooNearToLeader(OwnClaim held) {
        Point2d place = mapFromBase.position();
        double own = way(place, held.entry);
        for (Mate mate : mates.all()) {
            Claim other = mate.report.claim().orElse(null);
            if (other != null && other.isHeld() && isSame(other.entry(), held.entry) && meets(held, other.passages())) {
                Point2d there = mate.report.mapFromBase().position();
                double lead = way(there, held.entry) - own;
                boolean isAhead = lead > 0 || (lead == 0 && mate.robot.compareTo(self.robot()) < 0);
                if (isAhead && there.distanceTo(place) < 2 * self.radius() + BEHIND) {
                    return true;
                }
            }
        }
        return false;
    }

    /// How far a robot has come since the gate [m]; negative before it.
    private double way(Point2d place, Point2d entry) {
        boolean isInside = passages != null && passages.index(place.x(), place.y()) >= 0;
        return isInside ? place.distanceTo(entry) : -place.distanceTo(entry);
    }

    /// Whether places are in passages that a claim is for.
    boolean meets(OwnClaim own, List<Point2d> places) {
        Passages known = passages;
        if (known == null) {
            return false;
        }
        for (Point2d place : places) {
            int index = known.index(place.x(), place.y());
            for (Passage passage : own.passages()) {
                if (passage.index() == index) {
                    return true;
                }
            }
        }
        return false;
    }

    static boolean isSame(Point2d gate, Point2d other) {
        return gate.distanceTo(other) < SAME_GATE;
    }
}
