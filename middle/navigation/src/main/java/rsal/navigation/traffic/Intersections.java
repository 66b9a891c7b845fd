package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeMap;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.Junction;
import rsal.navigation.passage.Junction.Stretch;
import rsal.navigation.passage.Passages;
import rsal.navigation.traffic.IntersectionReport.Claim;

/// Who crosses a junction first, without a master: in the order of tickets, as [RightOfWay] has them, but only robots
/// whose paths through it come too near to each other wait (K. Dresner, P. Stone: A Multiagent Approach to Autonomous
/// Intersection Management, JAIR 31, 2008).
///
/// Differs in that no manager grants reservations of space and time: robots reserve what is left of their paths, and
/// each compares the others' with its own. Who waits does so in its lane, before the junction; nobody enters
/// while somebody stands where it would leave.
final class Intersections implements TrafficRule {
    private static final Duration LISTENING = Duration.ofMillis(300);
    private static final Duration ABSENT = Duration.ofSeconds(3); // who is not heard for so long
    private static final Duration BLOCKED =
            Duration.ofSeconds(25); // who needs longer to cross is an obstacle as others are
    private static final Duration STANDS = Duration.ofSeconds(3); // without moving
    private static final Duration IN_EXIT = Duration.ofSeconds(15); // for which who stands in the exit counts
    private static final Duration GREEN = Duration.ofSeconds(8); // for which others join who crosses
    private static final Duration ASKING = Duration.ofMillis(300);
    private static final Duration NEAR = Duration.ofMillis(500);
    private static final Duration ALONE = Duration.ofSeconds(2);
    private static final double CLAIM = 1.6; // m of path before a junction
    private static final double STOP = 0.15; // m before it
    private static final double INSIDE = 0.1; // m by which a robot is in it that has not asked
    private static final double LANDING = 1.5; // m of path; less between two junctions is no place to wait
    private static final double TAIL = 0.35; // m of path behind a junction that count
    private static final double EXIT = 1.0; // m of path behind that is to be free
    private static final double STEP = 0.2; // m between points of a path
    private static final double ROOM = 0.05; // m between bodies
    private static final double BEHIND = 0.9; // m between bodies in one lane
    private static final double BEHIND_WAITING = 1.2; // m; nearer, controllers begin to drive around it
    private static final double JOINING = 1.4; // m between bodies, to get into the lane of another one behind it
    private static final double FARTHEST = 2; // m of path on which others are followed
    private static final double BESIDE = 0.3; // m from the own lane
    private static final double LANE = 0.55; // m from a path
    private static final double NEIGHBORS = 10; // m
    private static final double VIEW = 8; // m of path

    private final TrafficType.Participant self;
    private final TreeMap<String, Neighbor> neighbors = new TreeMap<>();
    private final Set<String> askers = new TreeSet<>();
    private @Nullable Passages passages;
    private boolean isComputing;
    private @Nullable Own claim;
    private Pose2d mapFromBase = Pose2d.ORIGIN;
    private Instant now;
    private Instant published = Instant.MIN;
    private boolean waits;
    private boolean isInQueue;
    private long highest;
    private long number;
    private long done; // highest ticket that it had

    private static final class Neighbor {
        final String robot;
        IntersectionReport report;
        Instant heardAt;
        Pose2d movedTo;
        Instant movedAt;
        Instant heldAt; // since when it has been crossing

        Neighbor(String robot, IntersectionReport report, Instant now) {
            this.robot = robot;
            this.report = report;
            this.heardAt = now;
            this.movedTo = report.mapFromBase();
            this.movedAt = now;
            this.heldAt = now;
        }
    }

    private static final class Own {
        final long ticket;
        final Instant since;
        final List<Junction> junctions;
        boolean isHeld;
        boolean hasEntered;
        Pose2d mapFromEntry;
        List<Point2d> path = List.of();

        Own(long ticket, Instant since, List<Junction> junctions, Pose2d mapFromEntry) {
            this.ticket = ticket;
            this.since = since;
            this.junctions = junctions;
            this.mapFromEntry = mapFromEntry;
        }

        Claim report() {
            return new Claim(ticket, isHeld, mapFromEntry, path);
        }
    }

    private enum Access {
        FREE,
        ASKED,
        TAKEN
    }

    Intersections(TrafficType.Participant self) {
        this.self = self;
        this.now = self.start();
        self.link().onMessage(IntersectionReport.class, this::heard);
    }

    private void heard(String robot, IntersectionReport report) {
        Neighbor neighbor = neighbors.computeIfAbsent(robot, _ -> new Neighbor(robot, report, now));
        neighbor.heardAt = now;
        report.claim().ifPresent(other -> highest = Math.max(highest, other.ticket()));
        if (report.number() > neighbor.report.number()) {
            neighbor.report = report;
        }
        if (neighbor.report.claim().filter(Claim::isHeld).isEmpty()) {
            neighbor.heldAt = now;
        }
        if (neighbor.movedTo.distanceTo(report.mapFromBase()) > 0.2) {
            neighbor.movedTo = report.mapFromBase();
            neighbor.movedAt = now;
        }
        if (report.isAsking()) {
            askers.add(robot);
        }
    }

    @Override
    public TrafficAdvice advise(Instant at, Pose2d pose, Supplier<List<Point2d>> path) {
        now = at;
        mapFromBase = pose;
        List<Junction> known = junctions();
        TrafficAdvice advice = new TrafficAdvice.Proceed();
        if (!present().isEmpty()) {
            List<Point2d> corners = path.get();
            // from where the path is nearest on, not from the robot: beside its lane it would seem farther away
            List<Point2d> lane = corners.size() > 2 ? corners.subList(1, corners.size()) : corners;
            advice = known.isEmpty() ? advice : decide(known, lane);
            boolean follows = !known.isEmpty() && !isInQueue;
            if (follows && advice instanceof TrafficAdvice.Proceed && isSomebodyAhead(corners)) {
                advice = new TrafficAdvice.Halt();
            }
        }
        waits = advice instanceof TrafficAdvice.Halt;
        talk();
        return advice;
    }

    @Override
    public void stands(Instant at, Pose2d pose) {
        now = at;
        mapFromBase = pose;
        waits = false;
        Point2d place = pose.position();
        List<Junction> here = junctions().stream()
                .filter(junction -> junction.contains(place))
                .toList();
        if (here.isEmpty()) {
            drop();
        } else {
            if (claim == null) {
                claim = new Own(next(), now, here, pose);
            }
            claim.isHeld = true;
            claim.hasEntered = true;
            claim.path = List.of(place);
        }
        talk();
    }

    /// Another rule decides whom this robot follows now.
    void leaveFollowing(boolean toOthers) {
        isInQueue = toOthers;
    }

    @Override
    public List<Point2d> closed(Instant at) {
        return List.of();
    }

    @Override
    public boolean keepsLanes() {
        return !neighbors.isEmpty();
    }

    /// Empty until somebody else was heard.
    private List<Junction> junctions() {
        if (!neighbors.isEmpty() && !isComputing) {
            isComputing = true;
            self.passages().get().thenAccept(found -> passages = found);
        }
        return passages == null ? List.of() : passages.junctions();
    }

    private Collection<Neighbor> present() {
        return neighbors.values().stream()
                .filter(neighbor -> Duration.between(neighbor.heardAt, now).compareTo(ABSENT) <= 0)
                .toList();
    }

    private TrafficAdvice decide(List<Junction> known, List<Point2d> path) {
        leave();
        List<Stretch> ahead = chain(Junction.stretches(known, path, VIEW));
        if (ahead.isEmpty()) {
            drop();
            return new TrafficAdvice.Proceed();
        }
        double from = ahead.getFirst().from();
        List<Junction> wanted = ahead.stream().map(Stretch::junction).toList();
        if (claim != null && !claim.isHeld && !claim.junctions.equals(wanted)) {
            drop();
        }
        if (claim == null) {
            if (from > CLAIM) {
                return new TrafficAdvice.Proceed();
            }
            var fresh = new Own(next(), now, wanted, entry(path, from));
            measure(fresh, ahead, path);
            claim = joining(fresh);
            publish(true);
        }
        Own own = claim;
        measure(own, ahead, path);
        Junction first = wanted.getFirst();
        if (first.mapFromCenter().distanceTo(mapFromBase.position()) < first.radius() - INSIDE) {
            own.hasEntered = true;
            own.isHeld = true;
        }
        if (!own.isHeld) {
            giveUpTicket(own);
            Access access = access(own, path, ahead.getLast().to());
            if (access == Access.FREE) {
                own.isHeld = true;
                publish(false);
            } else if (from < STOP) {
                return new TrafficAdvice.Halt();
            }
        }
        return new TrafficAdvice.Proceed();
    }

    /// All junctions up to the next place to wait.
    private static List<Stretch> chain(List<Stretch> all) {
        var chain = new ArrayList<Stretch>();
        for (Stretch stretch : all) {
            if (!chain.isEmpty() && stretch.from() - chain.getLast().to() > LANDING) {
                break;
            }
            chain.add(stretch);
        }
        return chain;
    }

    private static Pose2d entry(List<Point2d> path, double from) {
        Point2d place = OwnClaim.along(path, from);
        Point2d on = OwnClaim.along(path, from + STEP);
        return new Pose2d(place.x(), place.y(), Math.atan2(on.y() - place.y(), on.x() - place.x()));
    }

    private static void measure(Own own, List<Stretch> ahead, List<Point2d> path) {
        double from = ahead.getFirst().from();
        if (!own.isHeld) {
            own.mapFromEntry = entry(path, from);
        }
        var left = new ArrayList<Point2d>();
        for (double at = from; at < ahead.getLast().to() + TAIL; at += STEP) {
            left.add(OwnClaim.along(path, at));
        }
        own.path = left;
    }

    /// Who comes while others cross, and does not disturb them, goes with them, before those that have only begun to
    /// wait: to change the direction costs the time in which the junction empties. Others wait [#GREEN] longer at
    /// most, as their tickets tell when they came. All have to answer to the earlier ticket, too, before it counts.
    private Own joining(Own fresh) {
        Claim mine = fresh.report();
        boolean crosses = false;
        long earliest = Long.MAX_VALUE;
        for (Neighbor neighbor : present()) {
            Claim other = neighbor.report.claim().orElse(null);
            if (other == null) {
                continue;
            }
            boolean meets =
                    mine.meets(other, self.radius() + neighbor.report.radius() + ROOM) && !mine.comesWith(other);
            if (other.isHeld() && meets) {
                return fresh;
            }
            crosses |= other.isHeld();
            earliest = meets ? Math.min(earliest, other.ticket()) : earliest;
        }
        boolean isRecent = earliest > now.minus(GREEN).toEpochMilli();
        if (!crosses || earliest == Long.MAX_VALUE || !isRecent || earliest - 1 <= done) {
            return fresh;
        }
        var joined = new Own(earliest - 1, now, fresh.junctions, fresh.mapFromEntry);
        joined.path = fresh.path;
        return joined;
    }

    /// Lets go of a junction that it was in and is out of.
    private void leave() {
        if (claim != null && claim.hasEntered) {
            Point2d place = mapFromBase.position();
            boolean isOut = claim.junctions.stream()
                    .noneMatch(junction -> junction.mapFromCenter().distanceTo(place) < junction.radius() + TAIL);
            if (isOut) {
                drop();
            }
        }
    }

    private void drop() {
        if (claim != null) {
            done = Math.max(done, claim.ticket);
            claim = null;
            publish(false);
        }
    }

    /// Who waits behind another robot has no use of an earlier ticket: those that wait for it would wait in a circle.
    private void giveUpTicket(Own own) {
        Claim mine = own.report();
        for (Neighbor neighbor : present()) {
            Claim other = neighbor.report.claim().orElse(null);
            if (other != null
                    && !other.isHeld()
                    && mine.comesWith(other)
                    && isAhead(mine, neighbor)
                    && other.ticket() > own.ticket) {
                done = Math.max(done, own.ticket);
                var again = new Own(next(), now, own.junctions, own.mapFromEntry);
                again.path = own.path;
                claim = again;
                publish(true);
                return;
            }
        }
    }

    private boolean isAhead(Claim mine, Neighbor neighbor) {
        double lead = mine.progress(neighbor.report.mapFromBase().position()) - mine.progress(mapFromBase.position());
        return lead > 0 || (lead == 0 && neighbor.robot.compareTo(self.robot()) < 0);
    }

    private Access access(Own own, List<Point2d> path, double end) {
        Claim mine = own.report();
        boolean allAnswered = !now.isBefore(own.since.plus(LISTENING));
        for (Neighbor neighbor : present()) {
            Claim other = neighbor.report.claim().orElse(null);
            if (other != null && isFirst(mine, neighbor, other)) {
                return Access.TAKEN;
            }
            allAnswered &= neighbor.report.heard().getOrDefault(self.robot(), 0L) >= own.ticket;
        }
        if (claim != own) {
            return Access.ASKED;
        }
        boolean isPatient = Duration.between(own.since, now).compareTo(IN_EXIT) < 0;
        if (isPatient && isSomebodyStanding(path, end)) {
            return Access.TAKEN;
        }
        return allAnswered ? Access.FREE : Access.ASKED;
    }

    /// Whether another robot's claim goes before the own one.
    private boolean isFirst(Claim mine, Neighbor neighbor, Claim other) {
        if (!mine.meets(other, self.radius() + neighbor.report.radius() + ROOM)) {
            return false;
        }
        if (mine.comesWith(other)) {
            return !other.isHeld() && isAhead(mine, neighbor);
        }
        if (other.isHeld()) {
            return Duration.between(neighbor.heldAt, now).compareTo(BLOCKED) < 0;
        }
        return other.ticket() < mine.ticket()
                || (other.ticket() == mine.ticket() && neighbor.robot.compareTo(self.robot()) < 0);
    }

    private Duration still(Neighbor neighbor) {
        return Duration.between(neighbor.movedAt, now);
    }

    private boolean isSomebodyStanding(List<Point2d> path, double end) {
        for (Neighbor neighbor : present()) {
            Point2d place = neighbor.report.mapFromBase().position();
            boolean isStanding = still(neighbor).compareTo(STANDS) > 0;
            for (double at = end; isStanding && at <= end + EXIT; at += STEP) {
                if (OwnClaim.along(path, at).distanceTo(place) < self.radius() + neighbor.report.radius()) {
                    return true;
                }
            }
        }
        return false;
    }

    /// Whether a robot in the own lane is just ahead: it is followed, not overtaken. Never each of two is ahead of the
    /// other, as that is measured in the mean of their directions.
    private boolean isSomebodyAhead(List<Point2d> path) {
        for (Neighbor neighbor : present()) {
            boolean drives = neighbor.report.waits() || still(neighbor).compareTo(STANDS) < 0;
            Pose2d there = neighbor.report.mapFromBase();
            if (drives && lead(there) > 0 && there.distanceTo(mapFromBase) < farthest(path, neighbor.report)) {
                for (double at = STEP; at <= FARTHEST; at += STEP) {
                    Pose2d on = entry(path, at);
                    if (on.distanceTo(there) < LANE && Math.cos(on.theta() - there.theta()) > 0.5) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

    private double lead(Pose2d there) {
        double x = Math.cos(mapFromBase.theta()) + Math.cos(there.theta());
        double y = Math.sin(mapFromBase.theta()) + Math.sin(there.theta());
        return (there.x() - mapFromBase.x()) * x + (there.y() - mapFromBase.y()) * y;
    }

    /// How far ahead another robot counts [m].
    private double farthest(List<Point2d> path, IntersectionReport other) {
        Pose2d lane = entry(path, FARTHEST);
        double beside = Math.abs((mapFromBase.y() - lane.y()) * Math.cos(lane.theta())
                - (mapFromBase.x() - lane.x()) * Math.sin(lane.theta()));
        double between = beside > BESIDE ? JOINING : other.waits() ? BEHIND_WAITING : BEHIND;
        return self.radius() + other.radius() + between;
    }

    private long next() {
        highest = Math.max(now.toEpochMilli(), highest) + 1;
        return highest;
    }

    private void talk() {
        Own own = claim;
        boolean asks = own != null && !own.isHeld;
        Duration period = own != null ? ASKING : isNobodyNear() ? ALONE : NEAR;
        if (Duration.between(published, now).compareTo(period) >= 0) {
            publish(asks);
        }
        if (!askers.isEmpty()) {
            IntersectionReport report = report(false);
            askers.forEach(robot -> self.link().send(robot, report));
            askers.clear();
        }
    }

    private boolean isNobodyNear() {
        return neighbors.values().stream()
                .noneMatch(neighbor -> neighbor.report.mapFromBase().distanceTo(mapFromBase) < NEIGHBORS);
    }

    private void publish(boolean asks) {
        published = now;
        self.link().publish(report(asks));
    }

    private IntersectionReport report(boolean asks) {
        number++;
        Map<String, Long> heard = new HashMap<>();
        neighbors.forEach(
                (robot, neighbor) -> neighbor.report.claim().ifPresent(other -> heard.put(robot, other.ticket())));
        return new IntersectionReport(
                number, mapFromBase, self.radius(), Optional.ofNullable(claim).map(Own::report), waits, asks, heard);
    }

    @Override
    public boolean isAmongOthers(Instant at, Pose2d pose) {
        for (Neighbor neighbor : neighbors.values()) {
            if (Duration.between(neighbor.heardAt, at).compareTo(ABSENT) <= 0
                    && neighbor.report.mapFromBase().distanceTo(pose) < 4) {
                return true;
            }
        }
        return false;
    }
}
