package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Predicate;
import java.util.random.RandomGenerator;
import org.jspecify.annotations.Nullable;
import rsal.data.Angles;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.MultiPointTurn.Leg;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.avoid.Shunt;
import rsal.navigation.control.GoalChecker;
import rsal.navigation.device.PathNavigator.Parts;
import rsal.navigation.device.PathNavigator.Settings;
import rsal.navigation.device.PathNavigator.Situation;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Route;
import rsal.time.Scheduler;

/// One goal of a [PathNavigator], from its start to its one ending. When the robot gets no nearer, it first plans
/// again with what it sees in the way, then drives back a bit and turns to it again, and in the end gives up. Who does
/// not see behind turns about to drive back, as somebody may stand there; only where it has no room for that it backs
/// off. Where it stands between walls and nobody is near, it turns to and fro to where it has to go ([Shunting]).
final class Trip {
    private static final double NEARER = 0.1; // m or rad; less is no progress
    private static final double OFF_ROUTE = 0.8; // m
    private static final double SLACK = 0.8; // of the tolerance; the rest is for arriving
    private static final double SEEN_SLACK = 1.0; // m; someone may stand on the goal
    private static final double UNSURE = 1.0; // m
    private static final double HEAVY = 0.5; // weight of the best hypothesis
    private static final double NOT_ON_MAP = 0.3; // m; from the map's nearest wall
    private static final int MOST_DETOURS = 5;
    private static final int MOST_FOUND = 5; // times that it may find itself again and have all its patience
    private static final int MOST_BUMPS = 3; // into what it does not see, without getting on meanwhile
    private static final double GOT_ON = 1; // m
    private static final Duration BLOCKED = Duration.ofMillis(2500);
    private static final Duration HELD_UP = Duration.ofSeconds(6);
    private static final Duration HELD_UP_AGAIN = Duration.ofMillis(1500); // before it creeps back
    private static final Duration REMEMBERED = Duration.ofSeconds(15);
    private static final Duration LOST = Duration.ofSeconds(2); // someone may stand before its sensors for a moment
    private static final double ABOUT = Math.toRadians(45); // turned so far that it sees where it drives
    private static final Duration TURNING_ABOUT = Duration.ofSeconds(12);
    private static final Duration TURNING = Duration.ofSeconds(3);
    private static final double COMPANY = 1.5; // m
    private static final double STANDING = 0.15; // m; less is no way at all
    private static final double ONWARD = 0.3; // m that it must be able to go on when it has turned
    private static final Duration SEARCHING = Duration.ofSeconds(5);
    private static final double MOVED = 0.05; // m; with less, and less of a turn, shunting came to nothing
    private static final double TURNED = Math.toRadians(10);
    private static final double SLOWLY = 2; // times the time that shunting should take
    private static final int MOST_REFUSED = 6; // beats in a row

    private final Parts parts;
    private final Settings settings;
    private final Scheduler scheduler;
    private final RandomGenerator random;
    private final Pose2d mapFromGoal;
    private final Tolerance tolerance;
    private final GoalChecker goalChecker;
    private final Consumer<Trip> onEnd;
    private final GoalSource<Progress, Result> source = new GoalSource<>(() -> end(Result.Cancelled.asked()));
    private final Instant started;
    private List<Seen> seen = new ArrayList<>();
    private @Nullable Route route;
    private Pose2d mapFromBase = Pose2d.ORIGIN;
    private boolean knewPlace; // else that is nothing but the map's origin
    private Instant localized; // when it was last not lost
    private boolean unsure; // where it is, when it last looked
    private boolean planning;
    private Instant planned;
    private boolean arrived;
    private double yardstick = Double.POSITIVE_INFINITY; // what was left, when last nearer
    private Instant nearer;
    private Pose2d mapFromNearer = Pose2d.ORIGIN; // where it was then
    private double best = Double.POSITIVE_INFINITY; // least that was ever left
    private Instant giveUp;
    private int detours;
    private int found; // itself, after it was on its way and did not know any more where
    private int backedOff;
    private int shunted;
    private int bumps; // since it got on
    private double leftAtBump = Double.POSITIVE_INFINITY; // least that was left at one of these
    private Manoeuvre manoeuvre = Manoeuvre.NONE;
    private double back; // heading that leads back where it came from [rad], on the map
    private Instant manoeuvreEnds;
    private @Nullable Shunt shunt;
    private Pose2d mapFromShunt = Pose2d.ORIGIN; // where it began
    private int searches; // for ways to turn
    private boolean shuntedInVain; // so that something else is to be tried
    private boolean shuntedOn; // it got somewhere by that, and may have to go on so
    private int refused; // beats in a row in which it did not go on, as that was not safe

    private enum Manoeuvre {
        NONE,
        TURN_ABOUT,
        DRIVE_BACK,
        BACK_OFF,
        TURN,
        SHUNT
    }

    /// Something in the way that is not on the map.
    private record Seen(Point2d place, Instant time) {}

    Trip(
            Parts parts,
            Settings settings,
            Scheduler scheduler,
            RandomGenerator random,
            Pose2d mapFromGoal,
            Tolerance tolerance,
            Consumer<Trip> onEnd) {
        this.parts = parts;
        this.settings = settings;
        this.scheduler = scheduler;
        this.random = random;
        this.mapFromGoal = mapFromGoal;
        this.tolerance = tolerance;
        this.goalChecker = parts.goalCheckers().apply(mapFromGoal, tolerance);
        this.onEnd = onEnd;
        this.started = scheduler.instant();
        this.nearer = started;
        this.localized = started;
        this.planned = started;
        this.manoeuvreEnds = started;
        this.giveUp = started.plus(settings.patience());
    }

    /// Goes on where another trip is, if its goal was near this one's: then the robot need not stop.
    void succeed(Trip old) {
        seen = old.seen;
        mapFromBase = old.mapFromBase;
        knewPlace = old.knewPlace;
        Route way = old.route;
        if (way == null || !isSeeable(way.end(), mapFromGoal.position(), Math.max(1, way.remaining() / 4))) {
            return;
        }
        route = new Route(way.extended(mapFromBase.position(), mapFromGoal.position()));
        planned = old.planned;
        nearer = old.nearer;
        yardstick = left(route);
        if (old.manoeuvre != Manoeuvre.SHUNT) { // where that leads is for the old goal
            manoeuvre = old.manoeuvre;
            manoeuvreEnds = old.manoeuvreEnds;
        }
    }

    private boolean isSeeable(Point2d from, Point2d to, double within) {
        return from.distanceTo(to) <= within && parts.ways().map().straightCost(from, to) < Double.POSITIVE_INFINITY;
    }

    GoalHandle<Progress, Result> handle() {
        return source;
    }

    Pose2d mapFromGoal() {
        return mapFromGoal;
    }

    Path2d path() {
        return route == null ? Path2d.EMPTY : route.left(mapFromBase.position());
    }

    /// The way that its local planner means to go; turning to and fro, it is not asked.
    Path2d localPath() {
        return manoeuvre == Manoeuvre.SHUNT
                ? Path2d.EMPTY
                : new Path2d(parts.avoidance().way().stream()
                        .map(mapFromBase::transform)
                        .toList());
    }

    /// The first ending counts.
    void end(Result result) {
        if (!source.ended()) {
            onEnd.accept(this);
            source.end(result);
        }
    }

    /// Time that passed in a pause does not count.
    void resume() {
        Instant now = scheduler.instant();
        nearer = now;
        giveUp = now.plus(settings.patience());
    }

    /// What to command when nobody knows where the robot or anything else is.
    Twist2d blindBeat() {
        if (scheduler.instant().isAfter(giveUp)) {
            end(new Result.Stuck(
                    mapFromBase,
                    Duration.between(started, scheduler.instant()),
                    knewPlace
                            ? "It is not known any more where the robot is or what is around it."
                            : "It was never known where the robot is and what is around it."));
        }
        return Twist2d.STOP;
    }

    /// What to command now.
    Twist2d beat(Situation now) {
        mapFromBase = now.mapFromBase();
        knewPlace = true;
        if (!isLost(now)) {
            localized = now.now();
        }
        unsure = isUnsure(now);
        if (unsure) {
            return lookAround(now);
        }
        boolean wasThere = arrived;
        arrived = goalChecker.isAtPlace(mapFromBase, now.motion().velocity());
        if (arrived) {
            if (!wasThere && manoeuvre == Manoeuvre.SHUNT) {
                endManoeuvre(now); // it would lead on, past the goal
            }
            return turnToGoal(now);
        }
        if (route == null) {
            mapFromNearer = mapFromBase;
            plan(now);
            return Twist2d.STOP;
        }
        route.advance(mapFromBase.position());
        watch(now, left(route));
        if (source.ended()) {
            return Twist2d.STOP;
        }
        if (isPlanDue(now, route)) {
            plan(now);
        }
        Point2d target = target(route);
        source.tell(new Stamped<>(
                now.now(),
                "map",
                new Progress(mapFromBase, route.remaining(), target, Duration.between(started, now.now()))));
        return switch (manoeuvre) {
            case NONE -> driveTo(target, route.end(), now);
            case TURN_ABOUT -> turnAbout(now);
            case DRIVE_BACK -> driveBack(now);
            case BACK_OFF -> backOff(now);
            case TURN -> turnTo(target, now);
            case SHUNT -> shunt(now);
        };
    }

    private Point2d target(Route way) {
        return way.target(mapFromBase.position(), parts.ways().map(), settings.lookahead());
    }

    private Twist2d driveTo(Point2d target, Point2d end, Situation now) {
        boolean last = target.distanceTo(end) < settings.lookahead() / 8;
        Pose2d baseFromMap = mapFromBase.inverse();
        List<Point2d> way = path().points().stream().map(baseFromMap::transform).toList();
        return parts.avoidance()
                .drive(now.obstacles(), new Target(baseFromMap.transform(target), last, way), now.motion());
    }

    private Twist2d turnToGoal(Situation now) {
        double angle = Angles.difference(mapFromBase.theta(), mapFromGoal.theta());
        if (goalChecker.isReached(mapFromBase, now.motion().velocity())) {
            if (!isLost(now)) {
                end(Result.Reached.by(now.estimate()));
            }
            return Twist2d.STOP;
        }
        watch(now, Math.abs(angle));
        if (source.ended()) {
            return Twist2d.STOP;
        }
        return switch (manoeuvre) {
            case BACK_OFF -> backOff(now);
            case SHUNT -> shunt(now);
            default -> parts.avoidance().turn(now.obstacles(), angle, now.motion());
        };
    }

    // Where am I?

    private static boolean isLost(Situation now) {
        return now.estimate().quality() == PoseEstimate.Quality.LOST;
    }

    private boolean isUnsure(Situation now) {
        if (Duration.between(localized, now.now()).compareTo(LOST) > 0) {
            return true;
        }
        var hypotheses = now.estimate().hypotheses();
        boolean ambiguous = !hypotheses.isEmpty() && hypotheses.getFirst().weight() < HEAVY;
        return ambiguous || now.estimate().covariance().positionDeviation() > UNSURE;
    }

    /// Drives about, since a localizer that stands still learns nothing new.
    private Twist2d lookAround(Situation now) {
        route = null;
        nearer = now.now(); // nothing holds it up
        if (now.now().isAfter(giveUp)) {
            giveUp(
                    now,
                    "It drove about for %d s and still is unsure where it is, by %.1f m."
                            .formatted(
                                    settings.patience().toSeconds(),
                                    now.estimate().covariance().positionDeviation()));
            return Twist2d.STOP;
        }
        Target onward = Target.at(new Point2d(settings.lookahead(), 0), false);
        Twist2d ahead = parts.avoidance().drive(now.obstacles(), onward, now.motion());
        return ahead.equals(Twist2d.STOP) ? parts.avoidance().turn(now.obstacles(), Math.PI / 2, now.motion()) : ahead;
    }

    // Does it get on?

    /// What is left while the robot is on its way: the way [m] and any turn at its end [rad]. So both arriving and
    /// turning then are progress.
    private static double left(Route way) {
        return way.remaining() + Math.PI;
    }

    /// @param left of the way, or of the turn at its end [rad]
    private void watch(Situation now, double left) {
        if (left < yardstick - NEARER) {
            yardstick = left;
            nearer = now.now();
            mapFromNearer = mapFromBase;
        }
        if (left < best - NEARER) {
            best = left;
            giveUp = now.now().plus(settings.patience());
        }
        if (now.now().isAfter(giveUp)) {
            var blockage = new Blockage(settings.patience(), backedOff, shunted, detours);
            Predicate<Point2d> onMap = place -> !isStrange(place);
            giveUp(
                    now,
                    arrived
                            ? blockage.turning(left, now.obstacles(), onMap)
                            : blockage.onTheWay(left - Math.PI, now.obstacles(), onMap));
            return;
        }
        boolean hitsBehind = manoeuvre == Manoeuvre.BACK_OFF && now.stalled();
        if (hitsBehind || (manoeuvre != Manoeuvre.NONE && now.now().isAfter(manoeuvreEnds))) {
            endManoeuvre(now);
        } else if (manoeuvre == Manoeuvre.NONE
                && (now.stalled() || heldUp(now).compareTo(isShunting(now) ? HELD_UP_AGAIN : HELD_UP) > 0)) {
            if (now.stalled() && bumpsAgain(left)) {
                giveUp(
                        now,
                        "It ran %d times into something that it does not see, last at (%.1f, %.1f)."
                                .formatted(MOST_BUMPS, mapFromBase.x(), mapFromBase.y()));
                return;
            }
            if (!now.stalled() && isWedged(now) && !shuntedInVain) {
                beginShunting(now);
                return;
            }
            shuntedInVain = false;
            backedOff++;
            if (now.seesBehind() || now.stalled() || arrived) {
                begin(Manoeuvre.BACK_OFF, settings.escapeTime());
            } else {
                back = mapFromBase.theta() + Math.PI;
                begin(Manoeuvre.TURN_ABOUT, TURNING_ABOUT);
            }
        }
    }

    /// Whether it is time to leave this alone.
    private boolean bumpsAgain(double left) {
        bumps = left < leftAtBump - GOT_ON ? 1 : bumps + 1;
        leftAtBump = Math.min(left, leftAtBump);
        return bumps >= MOST_BUMPS;
    }

    private void giveUp(Situation now, String why) {
        end(new Result.Stuck(mapFromBase, Duration.between(started, now.now()), why));
    }

    private Duration heldUp(Situation now) {
        return Duration.between(nearer, now.now());
    }

    /// Takes a random part of the time: two robots in each other's way should not do the same.
    private void begin(Manoeuvre next, Duration atMost) {
        manoeuvre = next;
        manoeuvreEnds = scheduler.instant().plusMillis((long) (atMost.toMillis() * random.nextDouble(0.3, 1)));
    }

    private void endManoeuvre(Situation now) {
        shuntedOn = manoeuvre == Manoeuvre.SHUNT && mapFromBase.distanceTo(mapFromShunt) > STANDING;
        shuntedInVain = manoeuvre == Manoeuvre.SHUNT
                && mapFromBase.distanceTo(mapFromShunt) < MOVED
                && Math.abs(Angles.difference(mapFromBase.theta(), mapFromShunt.theta())) < TURNED;
        if (manoeuvre == Manoeuvre.BACK_OFF || manoeuvre == Manoeuvre.DRIVE_BACK) {
            begin(Manoeuvre.TURN, TURNING);
        } else {
            manoeuvre = Manoeuvre.NONE;
            nearer = now.now();
            mapFromNearer = mapFromBase;
            parts.avoidance().reset();
            planned = now.now().minus(settings.replanPeriod());
        }
    }

    /// Whether it is walls that hold it up, all of which it knows: nobody is near whom it could wait for. Sonars that
    /// look ahead leave unknown what is behind.
    private boolean isWedged(Situation now) {
        if (parts.laser().isEmpty() && !now.seesBehind()) {
            return false;
        }
        Obstacles around = now.obstacles();
        for (int i = 0; i < around.count(); i++) {
            if (around.room(i) > 0 && Math.hypot(around.x(i), around.y(i)) < COMPANY) {
                return false;
            }
        }
        return mapFromBase.distanceTo(mapFromNearer) < STANDING;
    }

    /// Whether it got on by turning to and fro here, and may have to again.
    private boolean isShunting(Situation now) {
        return shuntedOn && mapFromBase.distanceTo(mapFromShunt) < GOT_ON && isWedged(now);
    }

    /// Looks for a way to turn to and fro to where it has to go on.
    private void beginShunting(Situation now) {
        manoeuvre = Manoeuvre.SHUNT;
        manoeuvreEnds = now.now().plus(SEARCHING);
        shunt = null;
        mapFromShunt = mapFromBase;
        int search = ++searches;
        double ahead = ahead();
        Pose2d odomFromBase = now.motion().odomFromBase();
        scheduler
                .compute(parts.shunting().search(now.obstacles(), toTurn(), ahead))
                .thenAccept(legs -> {
                    if (search == searches && manoeuvre == Manoeuvre.SHUNT) {
                        legs.ifPresentOrElse(found -> shuntAlong(found, ahead, odomFromBase), this::backOffInstead);
                    }
                })
                .whenComplete((_, error) -> {
                    if (error != null) { // of the search, or of what came of it
                        end(new Result.NoPath("The search for a way to turn failed: %s".formatted(error)));
                    }
                });
    }

    /// How far it must be able to go on when it has turned, which is not past its goal [m].
    private double ahead() {
        Route way = route;
        return arrived || way == null
                ? 0
                : Math.min(ONWARD, mapFromBase.position().distanceTo(target(way)));
    }

    private void backOffInstead() {
        backedOff++;
        begin(Manoeuvre.BACK_OFF, settings.escapeTime());
    }

    /// By what angle, to go on from here [rad].
    private double toTurn() {
        Route way = route;
        return arrived || way == null
                ? Angles.difference(mapFromBase.theta(), mapFromGoal.theta())
                : mapFromBase.bearingTo(target(way));
    }

    /// Goes on by what the search found open, too: a local planner that wants more room would stand there.
    ///
    /// @param ahead how far that is [m]
    private void shuntAlong(List<Leg> legs, double ahead, Pose2d odomFromBase) {
        List<Leg> all = new ArrayList<>(legs);
        if (ahead > 0) {
            all.add(new Leg(ahead, 0));
        }
        var next = new Shunt(all, settings.escapeSpeed(), odomFromBase);
        shunt = next;
        shunted += legs.isEmpty() ? 0 : 1;
        refused = 0;
        manoeuvreEnds = scheduler.instant().plusMillis((long) (SLOWLY * next.seconds() * 1000));
    }

    private Twist2d shunt(Situation now) {
        if (shunt == null) {
            return Twist2d.STOP;
        }
        Twist2d wanted = shunt.drive(now.motion());
        Twist2d safe = parts.shunting().guarded(wanted, now.motion().velocity(), now.obstacles());
        refused = safe.equals(Twist2d.STOP) ? refused + 1 : 0;
        if (shunt.done() || refused == MOST_REFUSED) {
            endManoeuvre(now);
        }
        return safe;
    }

    private Twist2d turnAbout(Situation now) {
        double angle = Angles.difference(mapFromBase.theta(), back);
        Twist2d turn = parts.avoidance().turn(now.obstacles(), angle, now.motion());
        if (Math.abs(angle) < ABOUT) {
            begin(Manoeuvre.DRIVE_BACK, settings.escapeTime());
        } else if (turn.equals(Twist2d.STOP)) {
            begin(Manoeuvre.BACK_OFF, settings.escapeTime());
        }
        return turn;
    }

    private Twist2d driveBack(Situation now) {
        double angle = Angles.difference(mapFromBase.theta(), back);
        Target away = Target.at(new Point2d(Math.cos(angle), Math.sin(angle)), false);
        Twist2d fast = parts.avoidance().drive(now.obstacles(), away, now.motion());
        double share = Math.min(1, settings.escapeSpeed() / Math.max(settings.escapeSpeed(), fast.vx()));
        return parts.avoidance().guarded(now.obstacles(), Twist2d.drive(share * fast.vx(), fast.omega()), now.motion());
    }

    private Twist2d backOff(Situation now) {
        Twist2d back = Twist2d.drive(-settings.escapeSpeed(), 0);
        Twist2d safe = parts.avoidance().guarded(now.obstacles(), back, now.motion());
        if (safe.equals(Twist2d.STOP)) {
            endManoeuvre(now);
        }
        return safe;
    }

    private Twist2d turnTo(Point2d target, Situation now) {
        double bearing = mapFromBase.bearingTo(target);
        if (Math.abs(bearing) < 2 * NEARER) {
            endManoeuvre(now);
        }
        return parts.avoidance().turn(now.obstacles(), bearing, now.motion());
    }

    // Which way?

    private boolean isPlanDue(Situation now, Route way) {
        Duration age = Duration.between(planned, now.now());
        boolean urgent = heldUp(now).compareTo(BLOCKED) > 0 || way.offset() > OFF_ROUTE;
        return age.compareTo(settings.replanPeriod()) >= 0 || (urgent && age.compareTo(BLOCKED) >= 0);
    }

    private void plan(Situation now) {
        if (planning) {
            return;
        }
        planning = true;
        planned = now.now();
        seen.removeIf(s -> s.time().plus(REMEMBERED).isBefore(now.now()));
        if (heldUp(now).compareTo(BLOCKED) > 0) {
            remember(now);
        }
        var obstacles = seen.stream().map(Seen::place).toList();
        Point2d start = mapFromBase.position();
        scheduler
                .compute(() -> find(start, obstacles))
                .thenAccept(plan -> {
                    planning = false;
                    if (!source.ended() && !unsure) {
                        adopt(plan);
                    }
                })
                .whenComplete((_, error) -> {
                    if (error != null) { // of the search, or of what came of it
                        planning = false;
                        end(new Result.NoPath("Planning failed: %s".formatted(error)));
                    }
                });
    }

    /// Around what is seen, or else as if it would go away.
    private Plan find(Point2d start, List<Point2d> obstacles) {
        Point2d goal = mapFromGoal.position();
        double slack = SLACK * tolerance.distance();
        if (!obstacles.isEmpty()) {
            Plan around = parts.ways().plan(start, goal, Math.max(SEEN_SLACK, slack), obstacles);
            if (around instanceof Plan.Found) {
                return around;
            }
        }
        return parts.ways().plan(start, goal, slack, List.of());
    }

    private void adopt(Plan plan) {
        switch (plan) {
            case Plan.Found(var path, var _, var _) -> {
                Route before = route;
                route = new Route(path);
                yardstick = left(route);
                if (before == null) {
                    if (best < Double.POSITIVE_INFINITY && found < MOST_FOUND) {
                        found++;
                        beginAnew();
                    }
                } else if (yardstick > left(before) + 1 && detours < MOST_DETOURS) {
                    detours++;
                    beginAnew();
                }
            }
            case Plan.None(var why) -> {
                if (route == null) {
                    end(new Result.NoPath(why));
                }
            }
        }
    }

    /// What was left before says nothing of the way that it has now, for which it has all its patience.
    private void beginAnew() {
        best = yardstick;
        leftAtBump = yardstick;
        giveUp = scheduler.instant().plus(settings.patience());
    }

    /// Notes what stands around and is not on the map.
    private void remember(Situation now) {
        Obstacles around = now.obstacles();
        for (int i = 0; i < around.count(); i++) {
            if (isStrange(around.at(i))) {
                seen.add(new Seen(mapFromBase.transform(around.at(i)), now.now()));
            }
        }
    }

    private boolean isStrange(Point2d baseFromPoint) {
        Point2d place = mapFromBase.transform(baseFromPoint);
        return parts.toNotFree().at(place.x(), place.y()) > NOT_ON_MAP;
    }
}
