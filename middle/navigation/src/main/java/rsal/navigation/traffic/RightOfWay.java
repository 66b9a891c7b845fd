package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.Gate;
import rsal.navigation.passage.Passage;
import rsal.navigation.passage.Passages;
import rsal.navigation.passage.Passages.Crossing;
import rsal.navigation.traffic.Mates.Mate;
import rsal.navigation.traffic.TrafficReport.Claim;
import rsal.navigation.traffic.TrafficReport.Follower;

/// Mutual exclusion in narrow passages without a master: Ricart, Agrawala: An optimal algorithm for mutual exclusion in
/// computer networks, CACM 24 (1981), with tickets after Lamport (1978).
///
/// Differs in that an answer is a report of the whole state and says which tickets it knows of, so that messages may be
/// lost and come twice; that a robot which does not answer for 3 s is taken for absent, unless it has the
/// passage; that the one that has it may take followers in its direction along; and that a robot in a passage has it,
/// whatever was agreed. All passages up to the next place to stand are wanted at once, so nobody has one and waits
/// for another. A passage is free again when its robot is measured to be outside, never by time.
final class RightOfWay implements TrafficRule {
    private static final Duration LISTENING = Duration.ofMillis(500); // before it goes, for who was not heard yet
    private static final Duration ABSENT = Duration.ofSeconds(3); // who does not answer for so long
    private static final Duration DEAF = Duration.ofSeconds(10); // who is heard, but does not answer for so long
    private static final Duration HELLO = Duration.ofSeconds(2); // while it has heard nobody
    private static final Duration ASKING = Duration.ofMillis(300);
    private static final Duration WAITING = Duration.ofSeconds(1);
    private static final Duration LEAVING = Duration.ofSeconds(6); // for which it tells where it is
    private static final double LOST_WAY = 2; // m farther than claimed from
    private static final double TURN_OFF = 2.5; // m of path before a passage at which it leaves for a waiting place
    private static final double STOP = 0.6; // m before a passage
    private static final double CLEAR = 0.15; // m between a robot's middle and the passage that it has left
    private static final double HIDING = 4; // m; robots that are nearer cover much of a scan
    private static final double FAR = 60; // m of path that count for a claim

    private final TrafficType.Participant self;
    private final Settings settings;
    private final Mates mates = new Mates();
    private final WaitingChoice places;
    private final GateNeighbors neighbors;
    private final Set<String> askers = new TreeSet<>();
    private final List<Follower> followers = new ArrayList<>();
    private @Nullable Passages passages;
    private boolean isComputing;
    private @Nullable OwnClaim claim;
    private Pose2d mapFromBase = Pose2d.ORIGIN;
    private Instant now;
    private Instant published = Instant.MIN;
    private Instant leftAt = Instant.MIN; // a passage
    private long done;
    private long number;

    /// @param claimDistance of path before a passage [m]
    /// @param batch robots in one direction while others wait
    /// @param closeAfter for how long a robot in a passage does not move until the passage counts as closed
    record Settings(double claimDistance, int batch, Duration closeAfter) {}

    /// What keeps a robot from a passage.
    private enum Access {
        FREE,
        /// Not all have answered.
        ASKED,
        /// Somebody else goes first.
        TAKEN
    }

    RightOfWay(TrafficType.Participant self, Settings settings) {
        this.self = self;
        this.settings = settings;
        this.now = self.start();
        this.places = new WaitingChoice(mates, self.robot(), self.radius());
        this.neighbors = new GateNeighbors(mates, self);
        self.link().onMessage(TrafficReport.class, this::heard);
    }

    private void heard(String robot, TrafficReport report) {
        mates.heard(robot, report, now);
        if (report.isAsking()) {
            askers.add(robot);
        }
    }

    @Override
    public TrafficAdvice advise(Instant at, Pose2d pose, Supplier<List<Point2d>> path) {
        now = at;
        mapFromBase = pose;
        Passages known = known();
        if (known == null) {
            answer();
            return new TrafficAdvice.Proceed();
        }
        neighbors.see(at, pose, known);
        TrafficAdvice advice = decide(known, path.get());
        talk();
        return advice;
    }

    @Override
    public void stands(Instant at, Pose2d pose) {
        now = at;
        mapFromBase = pose;
        Passages known = known();
        neighbors.see(at, pose, known);
        if (known != null) {
            if (claim != null && !claim.isHeld) {
                drop();
            }
            release(List.of());
            occupy(known);
            talk();
        } else {
            answer();
        }
    }

    /// The passages, which are computed when somebody else was heard.
    private @Nullable Passages known() {
        if (mates.isEmpty()) {
            if (Duration.between(published, now).compareTo(HELLO) >= 0) {
                publish(true);
            }
        } else if (!isComputing) {
            isComputing = true;
            self.passages().get().thenAccept(found -> passages = found);
        }
        return passages;
    }

    private TrafficAdvice decide(Passages known, List<Point2d> path) {
        if (path.size() < 2) {
            release(List.of());
            return new TrafficAdvice.Proceed();
        }
        occupy(known);
        if (claim == null) {
            if (known.crossings(cut(path, settings.claimDistance)).isEmpty()) {
                return new TrafficAdvice.Proceed();
            }
            List<Crossing> all = known.crossings(cut(path, FAR));
            claim = new OwnClaim(mates.next(now), now, path, all);
            publish(true);
        }
        List<Crossing> ahead = known.crossings(cut(path, settings.claimDistance + LOST_WAY));
        if (claim.isHeld) {
            release(ahead);
            return claim == null ? new TrafficAdvice.Proceed() : drive(claim, ahead, path);
        }
        return approach(claim, ahead);
    }

    private TrafficAdvice drive(OwnClaim held, List<Crossing> ahead, List<Point2d> path) {
        Optional<Mate> opposed = opposed(held);
        if (opposed.isPresent()) {
            if (!isInside(held)) { // who waits outside keeps nobody out, nor do those that it has taken along
                held.isHeld = false;
                followers.clear();
                publish(false);
                return approach(held, ahead);
            }
            return backOut(held, opposed.get());
        }
        Optional<Crossing> last = ahead.stream()
                .filter(crossing -> held.contains(crossing.passage()))
                .reduce((_, next) -> next);
        last.ifPresent(crossing -> held.leavesBy(path, crossing.to()));
        if (neighbors.isTooNearToLeader(held)) {
            return new TrafficAdvice.Halt();
        }
        boolean leadsOn =
                ahead.stream().anyMatch(crossing -> crossing.from() < STOP && !held.contains(crossing.passage()));
        return leadsOn && !isInside(held) ? new TrafficAdvice.Halt() : new TrafficAdvice.Proceed();
    }

    private TrafficAdvice approach(OwnClaim wanted, List<Crossing> ahead) {
        Optional<Crossing> next = ahead.stream()
                .filter(crossing -> wanted.contains(crossing.passage()))
                .findFirst();
        if (next.isEmpty()) { // its path leads elsewhere now
            drop();
            return new TrafficAdvice.Proceed();
        }
        Access access = access(wanted);
        if (access == Access.FREE && (neighbors.isSomebodyLeaving(wanted) || !neighbors.isBehindLeader(wanted))) {
            access = Access.TAKEN;
        }
        if (access == Access.FREE) {
            wanted.isHeld = true;
            wanted.waiting = null;
            publish(false);
            return new TrafficAdvice.Proceed();
        }
        double left = next.get().from();
        if (access == Access.TAKEN && (left < TURN_OFF || wanted.waiting != null)) {
            wanted.waiting = places.choose(wanted, wanted.entryGate, mapFromBase.position());
            if (wanted.waiting != null) {
                return new TrafficAdvice.WaitAt(wanted.waiting, wanted.entry);
            }
        }
        return left < STOP ? new TrafficAdvice.Halt() : new TrafficAdvice.Proceed();
    }

    /// A robot in a passage has it, whatever was agreed.
    private void occupy(Passages known) {
        Point2d place = mapFromBase.position();
        Optional<Passage> here = known.at(place);
        if (here.isEmpty() || isPassingBy(here.get(), place)) {
            return;
        }
        if (claim != null && !claim.contains(here.get())) {
            drop();
        }
        if (claim == null) {
            claim = new OwnClaim(mates.next(now), now, here.get(), place);
        }
        if (!claim.isHeld) {
            claim.isHeld = true;
            claim.waiting = null;
            publish(false);
        }
    }

    /// Whether a robot that waits comes through the mouth of a passage on its path to its waiting place.
    private boolean isPassingBy(Passage here, Point2d place) {
        return claim != null
                && !claim.isHeld
                && claim.contains(here)
                && place.distanceTo(here.gateNear(place).mapFromGate()) < 2 * self.radius();
    }

    /// Lets go of passages that the robot is out of, and that are not ahead.
    private void release(List<Crossing> ahead) {
        OwnClaim held = claim;
        if (held == null || !held.isHeld) {
            return;
        }
        boolean changed = held.passages().removeIf(passage -> {
            boolean out = !isInside(passage);
            return out
                    && ahead.stream().noneMatch(crossing -> crossing.passage().equals(passage));
        });
        if (held.passages().isEmpty()) {
            drop();
        } else if (changed) {
            publish(false);
        }
    }

    private boolean isInside(OwnClaim held) {
        return held.passages().stream().anyMatch(this::isInside);
    }

    private boolean isInside(Passage passage) {
        return passage.distanceTo(mapFromBase.position()) < CLEAR;
    }

    private void drop() {
        if (claim != null) {
            done = Math.max(done, claim.ticket);
            leftAt = claim.isHeld ? now : leftAt;
            claim = null;
            publish(false);
        }
    }

    private Access access(OwnClaim wanted) {
        boolean invited = mates.all().stream()
                .flatMap(mate -> mate.report.followers().stream())
                .anyMatch(follower -> follower.robot().equals(self.robot()) && follower.ticket() == wanted.ticket);
        boolean allAnswered = !now.isBefore(wanted.since.plus(LISTENING));
        for (Mate mate : mates.all()) {
            if (isTaken(wanted, mate, invited)) {
                return Access.TAKEN;
            }
            allAnswered &= hasAnswered(wanted, mate);
        }
        return invited || allAnswered ? Access.FREE : Access.ASKED;
    }

    private boolean isTaken(OwnClaim wanted, Mate mate, boolean invited) {
        for (Follower follower : mate.report.followers()) {
            boolean counts = !follower.robot().equals(self.robot())
                    && !mates.isDone(follower.robot(), follower.ticket())
                    && neighbors.meets(wanted, follower.passages());
            if (counts && !(invited && GateNeighbors.isSame(follower.entry(), wanted.entry))) {
                return true;
            }
        }
        Claim other = mate.report.claim().orElse(null);
        if (other == null || !neighbors.meets(wanted, other.passages())) {
            return false;
        }
        if (invited) {
            return other.isHeld() && !GateNeighbors.isSame(other.entry(), wanted.entry);
        }
        return other.isHeld() || wanted.isAfter(other, mate.robot, self.robot());
    }

    /// Whether a robot knows of a claim, or is not there any more.
    private boolean hasAnswered(OwnClaim wanted, Mate mate) {
        if (mate.report.heard().getOrDefault(self.robot(), 0L) >= wanted.ticket) {
            return true;
        }
        Instant from = mate.heardAt.isAfter(wanted.since) ? mate.heardAt : wanted.since;
        return Duration.between(from, now).compareTo(ABSENT) > 0
                || Duration.between(wanted.since, now).compareTo(DEAF) > 0;
    }

    /// Another robot in the same passage that comes from another gate, and was before.
    private Optional<Mate> opposed(OwnClaim held) {
        return mates.all().stream()
                .filter(mate -> mate.report
                        .claim()
                        .filter(other -> other.isHeld()
                                && neighbors.meets(held, other.passages())
                                && !GateNeighbors.isSame(other.entry(), held.entry)
                                && held.isAfter(other, mate.robot, self.robot())
                                && mate.still(now).compareTo(settings.closeAfter) < 0)
                        .isPresent())
                .findFirst();
    }

    /// To the gate that is nearer to this robot than to the other.
    private TrafficAdvice backOut(OwnClaim held, Mate other) {
        Gate best = held.entryGate;
        double most = Double.NEGATIVE_INFINITY;
        for (Passage passage : held.passages()) {
            for (Gate gate : passage.gates()) {
                double lead = other.report.mapFromBase().position().distanceTo(gate.mapFromGate())
                        - mapFromBase.position().distanceTo(gate.mapFromGate());
                if (lead > most) {
                    most = lead;
                    best = gate;
                }
            }
        }
        held.waiting = places.choose(held, best, mapFromBase.position());
        return held.waiting == null
                ? new TrafficAdvice.Halt()
                : new TrafficAdvice.WaitAt(held.waiting, best.mapFromGate());
    }

    /// Takes along who comes behind in the same direction.
    private void invite(OwnClaim held) {
        followers.removeIf(follower -> mates.isDone(follower.robot(), follower.ticket()));
        int most = Math.max(settings.batch, held.robotsPerDirection());
        boolean othersWait = false;
        for (Mate mate : mates.all()) {
            Claim other = mate.report.claim().orElse(null);
            othersWait |= other != null
                    && !other.isHeld()
                    && neighbors.meets(held, other.passages())
                    && !GateNeighbors.isSame(other.entry(), held.entry);
        }
        for (Mate mate : mates.all()) {
            Claim other = mate.report.claim().orElse(null);
            if (other == null) {
                continue;
            }
            boolean comes = !other.isHeld()
                    && neighbors.meets(held, other.passages())
                    && GateNeighbors.isSame(other.entry(), held.entry)
                    && mate.report.done() < other.ticket()
                    && followers.stream().noneMatch(follower -> follower.robot().equals(mate.robot))
                    && mate.report.mapFromBase().position().distanceTo(held.entry) < settings.claimDistance;
            if (comes && (!othersWait || followers.size() < most - 1)) {
                followers.add(new Follower(mate.robot, other.ticket(), other.passages(), other.entry()));
                publish(false);
            }
        }
    }

    private boolean isFollower(OwnClaim held) {
        return mates.all().stream()
                .flatMap(mate -> mate.report.followers().stream())
                .anyMatch(follower -> follower.robot().equals(self.robot()) && follower.ticket() == held.ticket);
    }

    private void talk() {
        followers.removeIf(follower -> mates.isDone(follower.robot(), follower.ticket()));
        OwnClaim own = claim;
        if (own != null) {
            if (own.isHeld && !isFollower(own)) {
                invite(own);
            }
            boolean asks = !own.isHeld;
            Duration period = asks && access(own) == Access.ASKED ? ASKING : WAITING;
            if (Duration.between(published, now).compareTo(period) >= 0) {
                publish(asks);
            }
        }
        boolean isLeaving = Duration.between(leftAt, now).compareTo(LEAVING) <= 0;
        if (isLeaving && Duration.between(published, now).compareTo(ASKING) >= 0) {
            publish(false);
        }
        answer();
    }

    private void answer() {
        if (!askers.isEmpty()) {
            TrafficReport report = report(false);
            askers.forEach(robot -> self.link().send(robot, report));
            askers.clear();
        }
    }

    private void publish(boolean asks) {
        published = now;
        self.link().publish(report(asks));
    }

    private TrafficReport report(boolean asks) {
        number++;
        return new TrafficReport(
                number,
                mapFromBase,
                Optional.ofNullable(claim).map(OwnClaim::report),
                asks,
                mates.heardTickets(),
                done,
                followers);
    }

    /// Whether it wants a passage, or has one.
    boolean hasClaim() {
        return claim != null;
    }

    @Override
    public boolean isAmongOthers(Instant at, Pose2d pose) {
        for (Mate mate : mates.all()) {
            if (Duration.between(mate.heardAt, at).compareTo(ABSENT) <= 0
                    && mate.report.mapFromBase().distanceTo(pose) < HIDING) {
                return true;
            }
        }
        return false;
    }

    @Override
    public List<Point2d> closed(Instant at) {
        Passages known = passages;
        if (known == null) {
            return List.of();
        }
        Optional<Passage> here = known.at(mapFromBase.position()); // which it must be able to leave
        var cells = new ArrayList<Point2d>();
        for (Mate mate : mates.all()) {
            mate.report
                    .claim()
                    .filter(other -> other.isHeld() && mate.still(at).compareTo(settings.closeAfter) > 0)
                    .ifPresent(other -> other.passages()
                            .forEach(place -> known.at(place)
                                    .filter(passage -> !here.equals(Optional.of(passage)))
                                    .filter(passage -> passage.distanceTo(
                                                    mate.report.mapFromBase().position())
                                            < self.radius()) // not one that waited long and goes only now
                                    .ifPresent(passage -> cells.addAll(passage.mapFromCells()))));
        }
        return cells;
    }

    /// The first part of a path.
    private static List<Point2d> cut(List<Point2d> path, double length) {
        var part = new ArrayList<Point2d>();
        part.add(path.getFirst());
        double done = 0;
        for (int i = 1; i < path.size() && done < length; i++) {
            double leg = path.get(i - 1).distanceTo(path.get(i));
            part.add(done + leg <= length ? path.get(i) : OwnClaim.along(path, length));
            done += leg;
        }
        return part;
    }
}
