package rsal.navigation.traffic;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.TreeMap;
import org.jspecify.annotations.Nullable;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.passage.Passages;
import rsal.navigation.passage.Passages.Crossing;

/// One robot of the team plans for all who has narrow passages when: the one of the least id (the bully algorithm,
/// Garcia-Molina 1982). Where it is silent for 3 s, the next one takes over; what robots have in passages they say
/// themselves.
///
/// The order of robots in each passage is that of a [Timetable]. It is kept as an action dependency graph is
/// (Hönig et al. 2019, "Persistent and robust execution of MAPF schedules in warehouses"): a robot may enter once those
/// before it have left, however late they are. Differs in that the plan is made again every half second, from where
/// robots are then, and that who has a permit keeps it.
final class CentralAgreement implements Agreement {
    private static final Duration LISTENING = Duration.ofMillis(1500); // before it permits anything, for who has what
    private static final Duration PERIOD = Duration.ofMillis(500); // of plans
    private static final Duration PRESENT = Duration.ofSeconds(1); // between reports while nobody wants anything
    private static final Duration ROUTES = Duration.ofSeconds(1);
    private static final double DEFAULT_SPEED = 0.4; // m/s, until it has driven
    private static final double LEAST_SPEED = 0.1; // m/s
    private static final double SETTLING = 10; // s in which the mean speed follows
    private static final double FAR = 60; // m of path that are reported
    private static final double UNKNOWN_LENGTH = 3; // m of passages whose robot has not said how long they are

    private final Team team;
    private final Map<String, HeardRoute> routes = new HashMap<>();
    private final TreeMap<String, HeardPermits> planners = new TreeMap<>(); // robots that say that they plan
    private final Map<String, Instant> wantedSince = new HashMap<>();
    private final Map<String, Long> permits = new TreeMap<>(); // while this robot plans
    private Map<String, Long> waiting = Map.of();
    private Instant now;
    private Instant alone; // nobody with a lesser id was heard since
    private Instant planned = Instant.MIN;
    private Instant reported = Instant.MIN;
    private Instant routed = Instant.MIN;
    private @Nullable RouteReport route;
    private @Nullable Pose2d before;
    private Instant looked;
    private double speed = DEFAULT_SPEED;
    private long number;

    private record HeardRoute(RouteReport report, Instant at) {}

    private record HeardPermits(PermitReport report, Instant at) {}

    /// A claim of a robot.
    private record Wish(String robot, long ticket, boolean isHeld, Timetable.Trip trip) {}

    CentralAgreement(Team team) {
        this.team = team;
        this.now = team.self().start();
        this.alone = now;
        this.looked = now;
        team.self().link().onMessage(RouteReport.class, this::heard);
        team.self().link().onMessage(PermitReport.class, this::heard);
    }

    private void heard(String robot, RouteReport report) {
        HeardRoute old = routes.get(robot);
        if (old == null || report.number() > old.report.number()) {
            routes.put(robot, new HeardRoute(report, now));
        }
    }

    private void heard(String robot, PermitReport report) {
        HeardPermits old = planners.get(robot);
        if (old == null || report.number() > old.report.number()) {
            planners.put(robot, new HeardPermits(report, now));
        }
    }

    @Override
    public PassageAccess access(Instant at, OwnClaim wanted) {
        Optional<PermitReport> decided = decided();
        String self = self();
        if (decided.isEmpty()) {
            return PassageAccess.ASKED;
        }
        if (decided.get().permits().getOrDefault(self, -1L) == wanted.ticket) {
            return PassageAccess.FREE;
        }
        boolean isKnown = decided.get().waiting().getOrDefault(self, -1L) == wanted.ticket;
        return isKnown ? PassageAccess.TAKEN : PassageAccess.ASKED;
    }

    /// What the robot that plans has said last.
    private Optional<PermitReport> decided() {
        return isPlanner()
                ? Optional.of(new PermitReport(number, permits, waiting))
                : planners.values().stream()
                        .filter(heard -> isFresh(heard.at))
                        .findFirst()
                        .map(HeardPermits::report);
    }

    private boolean isPlanner() {
        return planners.headMap(self()).values().stream().noneMatch(heard -> isFresh(heard.at));
    }

    private boolean isFresh(Instant at) {
        return Duration.between(at, now).compareTo(Team.ABSENT) <= 0;
    }

    @Override
    public void look(
            Instant at, Pose2d mapFromBase, Passages known, List<Point2d> mapFromPath, @Nullable OwnClaim own) {
        now = at;
        measureSpeed(mapFromBase, !mapFromPath.isEmpty() && (own == null || own.isHeld));
        if (isDue(routed, ROUTES)) {
            routed = now;
            boolean hadLegs = route != null && !route.legs().isEmpty();
            RouteReport left = route(known, mapFromPath);
            route = left;
            if (hadLegs || !left.legs().isEmpty()) {
                team.self().link().publish(left);
            }
        }
        if (!isPlanner()) {
            alone = now;
            permits.clear();
            waiting = Map.of();
        } else if (isDue(planned, PERIOD)) {
            planned = now;
            plan(mapFromBase, known, own);
        }
    }

    private boolean isDue(Instant last, Duration period) {
        return Duration.between(last, now).compareTo(period) >= 0;
    }

    private void measureSpeed(Pose2d pose, boolean isFree) {
        double passed = Duration.between(looked, now).toNanos() / 1e9;
        if (isFree && before != null && passed > 0) {
            double mean = pose.distanceTo(before) / passed;
            speed = Math.max(LEAST_SPEED, speed + Math.min(1, passed / SETTLING) * (mean - speed));
        }
        before = pose;
        looked = now;
    }

    private RouteReport route(Passages known, List<Point2d> path) {
        number++;
        var legs = new ArrayList<RouteReport.Leg>();
        if (path.size() < 2) {
            return new RouteReport(number, speed, 0, legs);
        }
        List<Point2d> near = OwnClaim.cut(path, FAR);
        List<Crossing> left = known.crossings(near);
        while (!left.isEmpty()) {
            var together = new OwnClaim(0, now, near, left);
            List<Crossing> next = left.stream()
                    .dropWhile(crossing -> together.contains(crossing.passage()))
                    .toList();
            Crossing last = left.get(left.size() - next.size() - 1);
            legs.add(new RouteReport.Leg(
                    together.places(), together.entry, left.getFirst().from(), last.to()));
            left = next;
        }
        return new RouteReport(number, speed, OwnClaim.length(near), legs);
    }

    private void plan(Pose2d mapFromBase, Passages known, @Nullable OwnClaim own) {
        List<Wish> wishes = wishes(mapFromBase, known, own);
        wantedSince.keySet().retainAll(wishes.stream().map(Wish::robot).toList());
        permits.entrySet()
                .removeIf(permit -> wishes.stream()
                        .noneMatch(wish -> wish.robot.equals(permit.getKey()) && wish.ticket == permit.getValue()));
        boolean changed = Duration.between(alone, now).compareTo(LISTENING) >= 0 && permit(wishes);
        var others = new TreeMap<String, Long>();
        for (Wish wish : wishes) {
            if (wish.ticket >= 0 && !wish.isHeld && !permits.containsKey(wish.robot)) {
                others.put(wish.robot, wish.ticket);
            }
        }
        changed |= !others.equals(waiting);
        waiting = others;
        if (changed || isDue(reported, permits.isEmpty() && waiting.isEmpty() ? PRESENT : PERIOD)) {
            reported = now;
            number++;
            team.self().link().publish(new PermitReport(number, permits, waiting));
        }
    }

    /// Permits each robot that is next in all of its passages. Returns whether there was one.
    private boolean permit(List<Wish> wishes) {
        List<Timetable.Entry> entries =
                Timetable.of(wishes.stream().map(Wish::trip).toList()).entries();
        boolean changed = false;
        for (Wish wish : wishes) {
            if (wish.ticket < 0 || wish.trip.isCommitted()) {
                continue;
            }
            Timetable.Leg leg = wish.trip.legs().getFirst();
            double start = entries.stream()
                    .filter(entry ->
                            entry.id().equals(wish.robot) && entry.leg().equals(leg))
                    .findFirst()
                    .orElseThrow()
                    .start();
            boolean isNext = entries.stream()
                    .noneMatch(entry -> !entry.id().equals(wish.robot)
                            && entry.start() <= start
                            && entry.leg().isAgainst(leg));
            if (isNext && !meetsPermitted(wish, wishes)) {
                permits.put(wish.robot, wish.ticket);
                changed = true;
            }
        }
        return changed;
    }

    private boolean meetsPermitted(Wish wish, List<Wish> all) {
        Timetable.Leg leg = wish.trip.legs().getFirst();
        return all.stream()
                .anyMatch(other -> !other.robot.equals(wish.robot)
                        && (other.isHeld || permits.getOrDefault(other.robot, -1L) == other.ticket)
                        && other.ticket >= 0
                        && other.trip.legs().getFirst().isAgainst(leg));
    }

    /// Of all robots that want something, or will, in the order of their ids.
    private List<Wish> wishes(Pose2d mapFromBase, Passages known, @Nullable OwnClaim own) {
        var wishes = new TreeMap<String, Wish>();
        wish(self(), known, mapFromBase, own == null ? null : own.report(), route)
                .ifPresent(wish -> wishes.put(wish.robot, wish));
        for (Mates.Mate mate : team.mates().all()) {
            TrafficReport.Claim claim = mate.report
                    .claim()
                    .filter(each -> each.ticket() > mate.report.done())
                    .orElse(null);
            HeardRoute heard = routes.get(mate.robot);
            RouteReport ahead = heard != null && isFresh(heard.at) ? heard.report : null;
            if (ahead != null || isFresh(mate.heardAt) || (claim != null && claim.isHeld())) {
                wish(mate.robot, known, mate.report.mapFromBase(), claim, ahead)
                        .ifPresent(wish -> wishes.put(wish.robot, wish));
            }
        }
        return List.copyOf(wishes.values());
    }

    private Optional<Wish> wish(
            String robot,
            Passages known,
            Pose2d mapFromBase,
            TrafficReport.@Nullable Claim claim,
            @Nullable RouteReport reported) {
        List<Timetable.Leg> legs = new ArrayList<>();
        if (reported != null) {
            reported.legs()
                    .forEach(leg -> legs.add(
                            new Timetable.Leg(indices(known, leg.passages()), leg.entry(), leg.from(), leg.to())));
        }
        double length = reported == null ? 0 : reported.left();
        double speedThere = reported == null ? DEFAULT_SPEED : reported.speed();
        if (claim == null) {
            return legs.isEmpty()
                    ? Optional.empty()
                    : Optional.of(
                            new Wish(robot, -1, false, new Timetable.Trip(robot, speedThere, length, 0, false, legs)));
        }
        List<Integer> claimed = indices(known, claim.passages());
        Timetable.Leg first = first(claim, claimed, legs, mapFromBase);
        legs.removeIf(
                leg -> leg.from() <= first.from() || leg.passages().stream().anyMatch(claimed::contains));
        legs.addFirst(first);
        boolean isPermitted = permits.getOrDefault(robot, -1L) == claim.ticket();
        Instant since = wantedSince.computeIfAbsent(robot, _ -> now);
        double waited = Duration.between(since, now).toNanos() / 1e9;
        return Optional.of(new Wish(
                robot,
                claim.ticket(),
                claim.isHeld(),
                new Timetable.Trip(
                        robot, speedThere, Math.max(length, first.to()), waited, claim.isHeld() || isPermitted, legs)));
    }

    /// What is claimed, with its lengths if the robot has said how long its path through it is.
    private static Timetable.Leg first(
            TrafficReport.Claim claim, List<Integer> claimed, List<Timetable.Leg> legs, Pose2d mapFromBase) {
        for (Timetable.Leg leg : legs) {
            if (leg.passages().stream().anyMatch(claimed::contains)) {
                return new Timetable.Leg(claimed, claim.entry(), leg.from(), leg.to());
            }
        }
        double from = claim.isHeld() ? 0 : mapFromBase.position().distanceTo(claim.entry());
        return new Timetable.Leg(claimed, claim.entry(), from, from + UNKNOWN_LENGTH);
    }

    /// Passages of a larger robot may be none of this one.
    private static List<Integer> indices(Passages known, List<Point2d> places) {
        return places.stream()
                .map(place -> known.index(place.x(), place.y()))
                .filter(index -> index >= 0)
                .distinct()
                .toList();
    }

    private String self() {
        return team.self().robot();
    }
}
