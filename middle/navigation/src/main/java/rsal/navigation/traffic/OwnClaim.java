package rsal.navigation.traffic;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.navigation.passage.Gate;
import rsal.navigation.passage.Passage;
import rsal.navigation.passage.Passages.Crossing;

/// The passages that a robot wants, or has: all up to the next place in which it can stand free of them.
final class OwnClaim {
    private static final double LANDING = 1.5; // m of path; less between two passages is no place to stand
    private static final double HEADWAY = 1.1; // m between the middles of two robots that follow each other
    private static final double EXIT = 2.5; // m of path behind the last one, kept free of who waits

    final long ticket;
    final Instant since;
    final Point2d entry;
    final Gate entryGate;
    private final List<Passage> passages;
    private final double length; // m of path through them
    private List<Point2d> exit;

    @Nullable
    Point2d waiting;

    boolean isHeld;

    /// @param path corners, from the robot on
    /// @param crossings of that path, at least one
    OwnClaim(long ticket, Instant since, List<Point2d> path, List<Crossing> crossings) {
        this.ticket = ticket;
        this.since = since;
        this.passages = new ArrayList<>();
        double end = crossings.getFirst().to();
        for (Crossing crossing : crossings) {
            if (crossing.from() - end > LANDING) {
                break;
            }
            if (!passages.contains(crossing.passage())) {
                passages.add(crossing.passage());
            }
            end = crossing.to();
        }
        Point2d first = along(path, crossings.getFirst().from());
        this.entryGate = passages.getFirst().gateNear(first);
        this.entry = entryGate.mapFromGate();
        this.exit = exit(path, end);
        this.length = end - crossings.getFirst().from();
    }

    /// Of a robot that stands in a passage without a path.
    OwnClaim(long ticket, Instant since, Passage passage, Point2d place) {
        this.ticket = ticket;
        this.since = since;
        this.passages = new ArrayList<>(List.of(passage));
        this.entryGate = passage.gateNear(place);
        this.entry = entryGate.mapFromGate();
        this.exit = List.of();
        this.length = 0;
    }

    /// To change the direction costs the time in which one robot passes the whole length, and another robot in the
    /// same direction no more than its distance to the one before: so many that both are equal.
    int robotsPerDirection() {
        return 1 + (int) (length / HEADWAY);
    }

    private static List<Point2d> exit(List<Point2d> path, double from) {
        var exit = new ArrayList<Point2d>();
        for (double ahead = 0; ahead <= EXIT; ahead += 0.25) {
            exit.add(along(path, from + ahead));
        }
        return exit;
    }

    static Point2d along(List<Point2d> path, double way) {
        double done = 0;
        for (int i = 1; i < path.size(); i++) {
            Point2d from = path.get(i - 1);
            Point2d to = path.get(i);
            double length = from.distanceTo(to);
            if (done + length >= way && length > 0) {
                double share = Math.max(0, (way - done) / length);
                return new Point2d(from.x() + share * (to.x() - from.x()), from.y() + share * (to.y() - from.y()));
            }
            done += length;
        }
        return path.getLast();
    }

    /// The first part of a path.
    static List<Point2d> cut(List<Point2d> path, double length) {
        var part = new ArrayList<Point2d>();
        part.add(path.getFirst());
        double done = 0;
        for (int i = 1; i < path.size() && done < length; i++) {
            double leg = path.get(i - 1).distanceTo(path.get(i));
            part.add(done + leg <= length ? path.get(i) : along(path, length));
            done += leg;
        }
        return part;
    }

    /// Of a path [m].
    static double length(List<Point2d> path) {
        double length = 0;
        for (int i = 1; i < path.size(); i++) {
            length += path.get(i - 1).distanceTo(path.get(i));
        }
        return length;
    }

    List<Passage> passages() {
        return passages;
    }

    boolean contains(Passage passage) {
        return passages.contains(passage);
    }

    /// Whether the claim of another robot goes first.
    ///
    /// @param robot the other's id
    /// @param self the own one
    boolean isAfter(TrafficReport.Claim other, String robot, String self) {
        return other.ticket() < ticket || (other.ticket() == ticket && robot.compareTo(self) < 0);
    }

    /// A path of now leads out.
    void leavesBy(List<Point2d> path, double end) {
        exit = exit(path, end);
    }

    TrafficReport.Claim report() {
        return new TrafficReport.Claim(ticket, isHeld, entry, places(), exit, Optional.ofNullable(waiting));
    }

    List<Point2d> places() {
        return passages.stream().map(Passage::mapFromMiddle).toList();
    }
}
