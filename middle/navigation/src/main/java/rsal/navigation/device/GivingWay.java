package rsal.navigation.device;

import java.time.Duration;
import java.util.List;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Twist2d;
import rsal.navigation.device.PathNavigator.Parts;
import rsal.navigation.device.PathNavigator.Settings;
import rsal.navigation.device.PathNavigator.Situation;
import rsal.navigation.traffic.TrafficAdvice;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Route;
import rsal.time.Scheduler;

/// Drives a robot to where it waits while others go first, and turns it to the gate there.
final class GivingWay {
    private static final double AT_PLACE = 0.12; // m
    private static final double LEFT_PLACE = 0.35; // m; others may push it, and its localizer may
    private static final double TURNED = 0.3; // rad

    private final Parts parts;
    private final Settings settings;
    private final Scheduler scheduler;
    private final PathFollower follower;
    private @Nullable Point2d mapFromPlace;
    private @Nullable PathPlanning planning;
    private boolean isThere;

    GivingWay(Parts parts, Settings settings, Scheduler scheduler) {
        this.parts = parts;
        this.settings = settings;
        this.scheduler = scheduler;
        this.follower = new PathFollower(parts.avoidance(), settings.lookahead());
    }

    boolean isActive() {
        return mapFromPlace != null;
    }

    /// The robot goes on.
    void end() {
        if (mapFromPlace != null) {
            parts.avoidance().reset();
        }
        mapFromPlace = null;
        planning = null;
        isThere = false;
    }

    /// What to command now.
    Twist2d command(TrafficAdvice.WaitAt advice, Situation now, Predicate<Point2d> isStrange) {
        if (!advice.mapFromPlace().equals(mapFromPlace)) {
            parts.avoidance().reset();
            mapFromPlace = advice.mapFromPlace();
            planning = new PathPlanning(
                    parts.planner(), scheduler, advice.mapFromPlace(), AT_PLACE, settings.replanPeriod());
            isThere = false;
        }
        double left = now.mapFromBase().position().distanceTo(advice.mapFromPlace());
        isThere = left < (isThere ? LEFT_PLACE : AT_PLACE);
        return isThere ? face(advice.mapFromGate(), now) : approach(now, isStrange);
    }

    private Twist2d face(Point2d mapFromGate, Situation now) {
        double angle = now.mapFromBase().bearingTo(mapFromGate);
        return Math.abs(angle) < TURNED ? Twist2d.STOP : parts.avoidance().turn(now.obstacles(), angle, now.motion());
    }

    private Twist2d approach(Situation now, Predicate<Point2d> isStrange) {
        PathPlanning own = planning;
        if (own == null) {
            return Twist2d.STOP;
        }
        Route route = own.route();
        if (!own.isPlanning() && (route == null || own.isDue(route, Duration.ZERO))) {
            own.plan(now.mapFromBase(), now.obstacles(), Duration.ZERO, isStrange, List.of())
                    .thenAccept(plan -> {
                        if (plan instanceof Plan.Found(Path2d path, double _, double _)) {
                            own.adopt(path);
                        }
                    });
        }
        if (route == null) {
            return Twist2d.STOP;
        }
        Point2d place = now.mapFromBase().position();
        route.advance(place);
        Point2d target = own.target(route, place, settings.lookahead());
        return follower.drive(
                now,
                target,
                follower.isLast(target, route.end()),
                own.left(place).points());
    }
}
