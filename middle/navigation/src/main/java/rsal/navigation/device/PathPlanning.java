package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletionStage;
import java.util.function.Predicate;
import org.jspecify.annotations.Nullable;
import rsal.data.Path2d;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.navigation.avoid.Obstacles;
import rsal.navigation.wavefront.GlobalPlanner;
import rsal.navigation.wavefront.Plan;
import rsal.navigation.wavefront.Route;
import rsal.time.Scheduler;

/// The path to one goal: plans it, and plans it again now and then, or at once when something that is not on the map
/// stands in the way.
final class PathPlanning {
    private static final double OFF_PATH = 0.8; // m
    private static final double SLACK = 0.8; // of the tolerance; the rest is for arriving
    private static final double SEEN_SLACK = 1.0; // m; someone may stand on the goal
    private static final Duration BLOCKED = Duration.ofMillis(2500);
    private static final Duration REMEMBERED = Duration.ofSeconds(15);

    private final GlobalPlanner planner;
    private final Scheduler scheduler;
    private final Point2d goal;
    private final double tolerance; // m
    private final Duration period;
    private List<Seen> seen = new ArrayList<>();
    private @Nullable Route route;
    private boolean isPlanning;
    private Instant planned;

    /// Something in the way that is not on the map.
    private record Seen(Point2d place, Instant time) {}

    /// @param tolerance how far from the goal the robot may stop [m]
    /// @param period between two plans, as a rule
    PathPlanning(GlobalPlanner planner, Scheduler scheduler, Point2d goal, double tolerance, Duration period) {
        this.planner = planner;
        this.scheduler = scheduler;
        this.goal = goal;
        this.tolerance = tolerance;
        this.period = period;
        this.planned = scheduler.instant();
    }

    /// Takes over the path to a former goal, with another end, if this goal is near that one. Remembers what was seen
    /// in any case.
    ///
    /// @return the path; empty when it took over none
    Optional<Route> succeed(PathPlanning old, Point2d position) {
        seen = old.seen;
        Route former = old.route;
        if (former == null || !isSeeable(former.end(), Math.max(1, former.remaining() / 4))) {
            return Optional.empty();
        }
        var path = new Route(former.extended(position, goal));
        route = path;
        planned = old.planned;
        return Optional.of(path);
    }

    private boolean isSeeable(Point2d from, double within) {
        return from.distanceTo(goal) <= within && planner.map().straightCost(from, goal) < Double.POSITIVE_INFINITY;
    }

    @Nullable
    Route route() {
        return route;
    }

    void forget() {
        route = null;
    }

    /// What is left, from where the robot is.
    Path2d left(Point2d position) {
        return route == null ? Path2d.EMPTY : route.left(position);
    }

    /// Where to head for on a path.
    Point2d target(Route path, Point2d position, double lookahead) {
        return path.target(position, planner.map(), lookahead);
    }

    /// The next look plans.
    void plansSoon() {
        planned = scheduler.instant().minus(period);
    }

    boolean isDue(Route path, Duration withoutProgress) {
        Duration age = Duration.between(planned, scheduler.instant());
        boolean urgent = withoutProgress.compareTo(BLOCKED) > 0 || path.offset() > OFF_PATH;
        return age.compareTo(period) >= 0 || (urgent && age.compareTo(BLOCKED) >= 0);
    }

    boolean isPlanning() {
        return isPlanning;
    }

    /// Plans, around what is seen and not on the map if the robot makes no progress. Not while [#isPlanning].
    ///
    /// @param isStrange whether a place in the base frame is not on the map
    /// @param closed places in the map frame that no path leads through, as they stay blocked
    CompletionStage<Plan> plan(
            Pose2d mapFromBase,
            Obstacles around,
            Duration withoutProgress,
            Predicate<Point2d> isStrange,
            List<Point2d> closed) {
        isPlanning = true;
        planned = scheduler.instant();
        seen.removeIf(s -> s.time().plus(REMEMBERED).isBefore(planned));
        if (withoutProgress.compareTo(BLOCKED) > 0) {
            remember(mapFromBase, around, isStrange);
        }
        var obstacles = seen.stream().map(Seen::place).toList();
        Point2d start = mapFromBase.position();
        return scheduler.compute(() -> find(start, obstacles, closed)).whenComplete((_, _) -> isPlanning = false);
    }

    private void remember(Pose2d mapFromBase, Obstacles around, Predicate<Point2d> isStrange) {
        for (int i = 0; i < around.count(); i++) {
            if (isStrange.test(around.at(i))) {
                seen.add(new Seen(mapFromBase.transform(around.at(i)), planned));
            }
        }
    }

    /// Around what is seen, or else as if it would go away.
    private Plan find(Point2d start, List<Point2d> obstacles, List<Point2d> closed) {
        double slack = SLACK * tolerance;
        if (!obstacles.isEmpty()) {
            var all = new ArrayList<>(obstacles);
            all.addAll(closed);
            Plan around = planner.plan(start, goal, Math.max(SEEN_SLACK, slack), all);
            if (around instanceof Plan.Found) {
                return around;
            }
        }
        Plan found = planner.plan(start, goal, slack, closed);
        return found instanceof Plan.None(String why) && !closed.isEmpty()
                ? new Plan.None(
                        "A robot that does not move blocks a narrow passage at (%.1f, %.1f), and no other path leads there. %s"
                                .formatted(
                                        closed.getFirst().x(), closed.getFirst().y(), why))
                : found;
    }

    void adopt(Path2d path) {
        route = new Route(path);
    }
}
