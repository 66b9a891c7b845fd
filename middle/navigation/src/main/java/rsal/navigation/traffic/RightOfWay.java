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

/// Drives a robot through narrow passages: it claims those ahead, waits beside the gate until an [Agreement] says that
/// it has them, and lets go of them behind it.
///
/// A robot in a passage has it, whatever was agreed. All passages up to the next place to stand are wanted at once, so
/// nobody has one and waits for another. A passage is free again when its robot is measured to be outside, never by
/// time.
final class RightOfWay implements TrafficRule {
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
    private final Agreement agreement;
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

    RightOfWay(TrafficType.Participant self, Settings settings, Agreement.Maker how) {
        this.self = self;
        this.settings = settings;
        this.now = self.start();
        this.places = new WaitingChoice(mates, self.robot(), self.radius());
        this.neighbors = new GateNeighbors(mates, self);
        this.agreement = how.of(new Agreement.Team(
                self, settings.batch, settings.claimDistance, mates, neighbors, () -> publish(false)));
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
        List<Point2d> left = path.get();
        TrafficAdvice advice = decide(known, left);
        talk(known, left);
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
            talk(known, List.of());
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
            if (known.crossings(OwnClaim.cut(path, settings.claimDistance)).isEmpty()) {
                return new TrafficAdvice.Proceed();
            }
            List<Crossing> all = known.crossings(OwnClaim.cut(path, FAR));
            claim = new OwnClaim(mates.next(now), now, path, all);
            publish(true);
        }
        List<Crossing> ahead = known.crossings(OwnClaim.cut(path, settings.claimDistance + LOST_WAY));
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
                agreement.leaveFollowers();
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
        PassageAccess access = agreement.access(now, wanted);
        if (access == PassageAccess.FREE
                && (neighbors.isSomebodyLeaving(wanted) || !neighbors.isBehindLeader(wanted))) {
            access = PassageAccess.TAKEN;
        }
        if (access == PassageAccess.FREE) {
            wanted.isHeld = true;
            wanted.waiting = null;
            publish(false);
            return new TrafficAdvice.Proceed();
        }
        double left = next.get().from();
        if (access == PassageAccess.TAKEN && (left < TURN_OFF || wanted.waiting != null)) {
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

    private void talk(Passages known, List<Point2d> path) {
        OwnClaim own = claim;
        agreement.look(now, mapFromBase, known, path, own);
        if (own != null) {
            boolean asks = !own.isHeld;
            Duration period = asks && agreement.access(now, own) == PassageAccess.ASKED ? ASKING : WAITING;
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
                agreement.followers());
    }

    /// Whether it wants a passage, or has one.
    boolean hasClaim() {
        return claim != null;
    }

    @Override
    public boolean isAmongOthers(Instant at, Pose2d pose) {
        for (Mate mate : mates.all()) {
            if (Duration.between(mate.heardAt, at).compareTo(Agreement.Team.ABSENT) <= 0
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
}
