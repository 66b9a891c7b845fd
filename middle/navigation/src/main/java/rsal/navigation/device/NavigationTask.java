package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.function.Consumer;
import rsal.data.Angles;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.navigation.control.GoalChecker;
import rsal.navigation.device.PathNavigator.Parts;
import rsal.navigation.device.PathNavigator.Settings;
import rsal.navigation.device.PathNavigator.Situation;
import rsal.navigation.recovery.Recovery;
import rsal.navigation.traffic.Lanes;
import rsal.navigation.traffic.TrafficAdvice;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Route;
import rsal.time.Scheduler;

/// One goal of a [PathNavigator], from its start to its one result. It plans a path ([PathPlanning]) and lets the
/// controller drive along it, until the goal checker says that the goal is reached. While the robot makes no progress
/// ([ProgressMonitor]) a recovery drives instead ([RecoveryList]); after a time without any it gives up. While the
/// robot does not know where it is ([PoseConfidence]) another recovery looks around.
final class NavigationTask {
    private static final double NOT_ON_MAP = 0.3; // m; from the map's nearest wall
    private static final int MOST_DETOURS = 5;
    private static final int MOST_FOUND = 5; // times that it may find itself again and have all its patience

    private final Parts parts;
    private final Settings settings;
    private final Scheduler scheduler;
    private final Pose2d mapFromGoal;
    private final GoalChecker goalChecker;
    private final Consumer<NavigationTask> onEnd;
    private final GoalSource<Progress, Result> source = new GoalSource<>(() -> end(Result.Cancelled.asked()));
    private final Instant started;
    private final PoseConfidence confidence;
    private final PathPlanning planning;
    private final ProgressMonitor progress;
    private final RecoveryList recoveries;
    private final RecoveryList lookingAround;
    private final PathFollower follower;
    private final GivingWay givingWay;
    private Pose2d mapFromBase = Pose2d.ORIGIN;
    private boolean knewPlace; // else that is nothing but the map's origin
    private boolean unsure; // where it is, when it last looked
    private boolean arrived;
    private int detours;
    private int found; // itself, after it was on its way and did not know any more where

    NavigationTask(
            Parts parts,
            Settings settings,
            Scheduler scheduler,
            Pose2d mapFromGoal,
            Tolerance tolerance,
            Consumer<NavigationTask> onEnd) {
        this.parts = parts;
        this.settings = settings;
        this.scheduler = scheduler;
        this.mapFromGoal = mapFromGoal;
        this.goalChecker = parts.plugins().newGoalChecker(mapFromGoal, tolerance);
        this.onEnd = onEnd;
        this.started = scheduler.instant();
        this.confidence = new PoseConfidence(started);
        this.planning = new PathPlanning(
                parts.planner(), scheduler, mapFromGoal.position(), tolerance.distance(), settings.replanPeriod());
        this.progress = new ProgressMonitor(parts.plugins().newProgressChecker(), settings.patience(), started);
        this.recoveries = parts.plugins().newRecoveries();
        this.lookingAround = parts.plugins().newLostRecovery();
        this.follower = new PathFollower(parts.avoidance(), settings.lookahead());
        this.givingWay = new GivingWay(parts, settings, scheduler);
    }

    /// Goes on where another task is, if its goal was near this one's: then the robot need not stop.
    void succeed(NavigationTask old) {
        mapFromBase = old.mapFromBase;
        knewPlace = old.knewPlace;
        planning.succeed(old.planning, mapFromBase.position()).ifPresent(path -> {
            progress.succeed(old.progress, left(path));
            recoveries.succeed(old.recoveries);
        });
    }

    GoalHandle<Progress, Result> handle() {
        return source;
    }

    Pose2d mapFromGoal() {
        return mapFromGoal;
    }

    Path2d path() {
        return planning.left(mapFromBase.position());
    }

    /// The path that its controller predicts; empty while a recovery follows one that the controller does not know.
    Path2d localPath() {
        return recoveries.followsOwnPath()
                ? Path2d.EMPTY
                : new Path2d(parts.avoidance().predictedTrajectory().stream()
                        .map(mapFromBase::transform)
                        .toList());
    }

    /// The first result counts.
    void end(Result result) {
        if (!source.ended()) {
            onEnd.accept(this);
            source.end(result);
        }
    }

    /// Time that passed in a pause does not count.
    void resume() {
        progress.resume(scheduler.instant());
    }

    /// Who comes along holds the robot up, which is nobody's failure.
    void onYielding() {
        progress.excuse(scheduler.instant());
    }

    /// What to command when it is not known where the robot is or what is around it.
    Twist2d blindBeat() {
        if (progress.isTimeToGiveUp(scheduler.instant())) {
            giveUp(
                    knewPlace
                            ? "The robot's pose or its surroundings are not known any more."
                            : "The robot's pose and its surroundings were never known.");
        }
        return Twist2d.STOP;
    }

    /// What to command now.
    Twist2d beat(Situation now) {
        mapFromBase = now.mapFromBase();
        knewPlace = true;
        unsure = confidence.isUnsure(now.now(), now.estimate(), parts.traffic().isAmongOthers(now.now(), mapFromBase));
        if (unsure) {
            parts.traffic().stands(now.now(), mapFromBase);
            return lookAround(now);
        }
        arrived = goalChecker.isAtPlace(mapFromBase, now.motion().velocity());
        if (arrived) {
            parts.traffic().stands(now.now(), mapFromBase);
            return turnToGoal(now);
        }
        Route path = planning.route();
        if (path == null) {
            parts.traffic().stands(now.now(), mapFromBase);
            progress.standsAt(mapFromBase);
            plan(now);
            return Twist2d.STOP;
        }
        return follow(path, now);
    }

    private Twist2d follow(Route path, Situation now) {
        path.advance(mapFromBase.position());
        TrafficAdvice advice = parts.traffic()
                .advise(
                        now.now(),
                        mapFromBase,
                        () -> path.leftAlong(mapFromBase.position()).points());
        if (!(advice instanceof TrafficAdvice.Proceed) && !recoveries.isRunning()) {
            return giveWay(advice, path, now);
        }
        if (givingWay.isActive()) {
            givingWay.end();
            planning.plansSoon();
        }
        Point2d target = planning.target(path, mapFromBase.position(), settings.lookahead());
        double ahead = mapFromBase.position().distanceTo(target);
        Recovery.Situation seen = see(now, left(path), mapFromBase.bearingTo(target), ahead);
        if (source.ended()) {
            return Twist2d.STOP;
        }
        if (planning.isDue(path, progress.withoutProgress(now.now()))) {
            plan(now);
        }
        source.publish(new Stamped<>(
                now.now(),
                "map",
                new Progress(mapFromBase, path.remaining(), target, Duration.between(started, now.now()))));
        return recoveries.isRunning() ? recover(seen) : driveTo(target, path.end(), now);
    }

    /// Others go first: that the robot makes no progress then is nobody's failure.
    private Twist2d giveWay(TrafficAdvice advice, Route path, Situation now) {
        progress.resume(now.now());
        if (planning.isDue(path, Duration.ZERO)) {
            plan(now);
        }
        source.publish(new Stamped<>(
                now.now(),
                "map",
                new Progress(
                        mapFromBase, path.remaining(), mapFromBase.position(), Duration.between(started, now.now()))));
        return advice instanceof TrafficAdvice.WaitAt place
                ? givingWay.command(place, now, this::isStrange)
                : Twist2d.STOP;
    }

    private Twist2d driveTo(Point2d target, Point2d end, Situation now) {
        boolean last = follower.isLast(target, end);
        var side = new KeepingRight(parts.toNotFree(), settings.bodyRadius());
        boolean keepsRight = now.meetsOthers() && !last;
        List<Point2d> way = keepsRight ? side.path(path().points()) : path().points();
        Point2d place = keepsRight ? side.target(mapFromBase.position(), target) : target;
        return follower.drive(now, place, last, way);
    }

    private Twist2d turnToGoal(Situation now) {
        double angle = Angles.difference(mapFromBase.theta(), mapFromGoal.theta());
        if (goalChecker.isReached(mapFromBase, now.motion().velocity())) {
            if (!PoseConfidence.isLost(now.estimate())) {
                end(Result.Reached.by(now.estimate()));
            }
            return Twist2d.STOP;
        }
        Recovery.Situation seen = see(now, Math.abs(angle), angle, 0);
        if (source.ended()) {
            return Twist2d.STOP;
        }
        return recoveries.isRunning() ? recover(seen) : parts.avoidance().turn(now.obstacles(), angle, now.motion());
    }

    /// What is left while the robot is on its way: the path [m] and any turn at its end [rad]. So both arriving and
    /// turning then are progress.
    private static double left(Route path) {
        return path.remaining() + Math.PI;
    }

    /// Looks whether the robot makes progress. If not, a recovery begins, or the task ends.
    ///
    /// @param left of the path, or of the turn at its end, as [rsal.navigation.control.ProgressChecker] has it
    private Recovery.Situation see(Situation now, double left, double turn, double ahead) {
        progress.see(now.now(), mapFromBase, left);
        Recovery.Situation seen = situation(now, turn, ahead);
        if (progress.isTimeToGiveUp(now.now())) {
            giveUp(new Blockage(settings.patience(), recoveries.counts(), detours)
                    .sentence(arrived, arrived ? left : left - Math.PI, now.obstacles(), place -> !isStrange(place)));
        } else if (recoveries.isRunning()) {
            endIfOver(seen);
        } else if (recoveries.isAnyDue(seen)) {
            beginRecovery(seen, left);
        }
        return seen;
    }

    private void beginRecovery(Recovery.Situation seen, double left) {
        if (seen.stalled() && progress.stallsTooOften(left)) {
            giveUp("It had %d collisions with something that it does not see, the last one at (%.1f, %.1f)."
                    .formatted(progress.stalls(), mapFromBase.x(), mapFromBase.y()));
        } else {
            recoveries.begin(seen);
            progress.onRecovery();
        }
    }

    private Recovery.Situation situation(Situation now, double turn, double ahead) {
        return new Recovery.Situation(
                now.now(),
                mapFromBase,
                now.motion(),
                now.stalled(),
                now.obstacles(),
                now.seesBehind(),
                now.seesBehind() || parts.laser().isPresent(),
                arrived,
                turn,
                ahead,
                progress.withoutProgress(now.now()),
                progress.mapFromProgress(),
                progress.tried());
    }

    private Twist2d recover(Recovery.Situation seen) {
        Twist2d command = recoveries.command(seen);
        endIfOver(seen);
        return command;
    }

    private void endIfOver(Recovery.Situation seen) {
        if (recoveries.endsNow(seen)) {
            progress.begin(seen.now(), mapFromBase);
            parts.avoidance().reset();
            planning.plansSoon();
        }
    }

    private Twist2d lookAround(Situation now) {
        planning.forget();
        progress.excuse(now.now());
        if (progress.isTimeToGiveUp(now.now())) {
            giveUp("It drove around for %d s, and its pose is still uncertain: %s."
                    .formatted(settings.patience().toSeconds(), PoseConfidence.doubt(now.estimate())));
            return Twist2d.STOP;
        }
        Recovery.Situation seen = situation(now, 0, 0);
        if (!lookingAround.isRunning()) {
            lookingAround.begin(seen);
        }
        Twist2d command = lookingAround.command(seen);
        lookingAround.endsNow(seen);
        return command;
    }

    private void giveUp(String why) {
        end(new Result.Stuck(mapFromBase, Duration.between(started, scheduler.instant()), why));
    }

    private void plan(Situation now) {
        if (planning.isPlanning()) {
            return;
        }
        List<Point2d> closed = parts.traffic().closed(now.now());
        planning.plan(mapFromBase, now.obstacles(), progress.withoutProgress(now.now()), this::isStrange, closed)
                .thenAccept(plan -> {
                    if (!source.ended() && !unsure) {
                        adopt(plan);
                    }
                })
                .whenComplete((_, error) -> {
                    if (error != null) { // of the search, or of adopting its result
                        end(new Result.NoPath("Planning failed: %s".formatted(error)));
                    }
                });
    }

    private void adopt(Plan plan) {
        switch (plan) {
            case Plan.Found(var path, var _, var _) -> {
                Route before = planning.route();
                Path2d adopted = inLane(path);
                planning.adopt(adopted);
                onPath(before == null ? Double.POSITIVE_INFINITY : left(before), adopted.length() + Math.PI);
            }
            case Plan.None(var why) -> {
                if (planning.route() == null
                        || !parts.traffic().closed(scheduler.instant()).isEmpty()) {
                    end(new Result.NoPath(why));
                }
            }
        }
    }

    private Path2d inLane(Path2d path) {
        return parts.traffic().keepsLanes()
                ? new Path2d(new Lanes(parts.toNotFree(), settings.bodyRadius()).right(path.points()))
                : path;
    }

    /// @param before what was left of the path before; infinite when there was none
    /// @param left of the new one
    private void onPath(double before, double left) {
        progress.onNewPath(left);
        if (before == Double.POSITIVE_INFINITY) {
            if (progress.hasBegun() && found < MOST_FOUND) {
                found++;
                progress.beginAgain(scheduler.instant(), left);
            }
        } else if (left > before + 1 && detours < MOST_DETOURS) {
            detours++;
            progress.beginAgain(scheduler.instant(), left);
        }
    }

    private boolean isStrange(Point2d baseFromPoint) {
        Point2d place = mapFromBase.transform(baseFromPoint);
        return parts.toNotFree().at(place.x(), place.y()) > NOT_ON_MAP;
    }
}
