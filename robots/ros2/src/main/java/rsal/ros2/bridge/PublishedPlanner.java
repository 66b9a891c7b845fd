package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeoutException;
import java.util.stream.Stream;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.device.Localizer;
import rsal.device.Planner;
import rsal.device.Planner.Result;
import rsal.robot.Robot;
import rsal.ros2.action.ActionServer;
import rsal.ros2.action.ActionServer.ServedGoal;
import rsal.ros2.action.ActionServer.Status;
import rsal.ros2.action.RequestVersions;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink;
import rsal.ros2.message.PathMessage;
import rsal.ros2.message.PlanningError;
import rsal.ros2.message.StampedPose;
import rsal.ros2.simulation.PublishedTime;

/// Planners of a robot of ours as Nav2's action `compute_path_to_pose`, as all distributions have it. `planner_id`
/// names the planner; without one, or with the name that Nav2's own configuration has, it is the first. Goals do not
/// disturb each other.
final class PublishedPlanner implements ActionServer.Handler {
    private static final String ACTION = "nav2_msgs/action/ComputePathToPose";
    private static final String USUAL = "GridBased";
    private static final Duration PATIENCE = Duration.ofSeconds(10); // for a path
    private static final int MOST_STOPS = 100;
    private static final String MAP = "map";

    private final Robot robot;
    private final OccupancyGrid map;
    private final PublishedTime time;
    private final ActionServer server;

    /// What is asked for.
    ///
    /// @param stops from the start to the goal
    /// @param asked when, in the run's time
    private record Question(Planner planner, List<Pose2d> stops, Instant asked) {
        Pose2d start() {
            return stops.getFirst();
        }

        Pose2d goal() {
            return stops.getLast();
        }
    }

    /// @param robot with one planner at least
    /// @param map that tells why there is no path
    /// @param services which this closes
    PublishedPlanner(Robot robot, OccupancyGrid map, RosLink link, Services services, String name, PublishedTime time) {
        this.robot = robot;
        this.map = map;
        this.time = time;
        server = new ActionServer(link, services, name, ACTION, RequestVersions.of(ACTION + "_SendGoal"), time, this);
    }

    @Override
    public void begin(ServedGoal goal, RosMessage fields) {
        String id = fields.text("planner_id");
        Optional<Planner> planner = planners()
                .filter(each ->
                        id.isEmpty() || id.equals(USUAL) || each.info().name().equals(id))
                .findFirst();
        List<RosMessage> places = places(fields);
        boolean hasStart = fields.get("use_start", Boolean.class);
        List<Pose2d> onMap = places.stream()
                .map(StampedPose::onMap)
                .flatMap(Optional::stream)
                .toList();
        Optional<Pose2d> start = hasStart ? onMap.stream().findFirst() : here();
        if (planner.isEmpty()) {
            fail(goal, PlanningError.INVALID_PLANNER, "The robot has no planner '%s'.".formatted(id));
        } else if (places.size() > MOST_STOPS) {
            fail(goal, PlanningError.UNKNOWN, "A path can have at most %d stops.".formatted(MOST_STOPS));
        } else if (onMap.size() < places.size()) {
            fail(goal, PlanningError.TF_ERROR, "Poses must be finite, and in the frame 'map'.");
        } else if (start.isEmpty()) {
            fail(goal, PlanningError.TF_ERROR, "The robot does not know where it is on the map.");
        } else {
            var stops = new ArrayList<Pose2d>(List.of(start.get()));
            onMap.stream().skip(hasStart ? 1 : 0).forEach(stops::add);
            answer(goal, new Question(planner.get(), stops, time.ofRun()));
        }
    }

    private Stream<Planner> planners() {
        return robot.devices().stream().filter(Planner.class::isInstance).map(Planner.class::cast);
    }

    private Optional<Pose2d> here() {
        return robot.find(Localizer.class)
                .flatMap(Localizer::latest)
                .filter(reading -> reading.frame().equals(MAP))
                .map(reading -> reading.value().mapFromBase());
    }

    /// The given start, what lies between, and the goal: `geometry_msgs/PoseStamped`.
    private static List<RosMessage> places(RosMessage fields) {
        var places = new ArrayList<RosMessage>();
        if (fields.get("use_start", Boolean.class)) {
            places.add(fields.message("start"));
        }
        if (fields.fields().containsKey("viapoints")) { // Lyrical's
            places.addAll(fields.messages("viapoints"));
        }
        places.add(fields.message("goal"));
        return places;
    }

    private void answer(ServedGoal goal, Question question) {
        time.within(PATIENCE, path(question)).whenComplete((result, error) -> {
            if (error instanceof TimeoutException) {
                fail(goal, PlanningError.TIMEOUT, "No path was found within %d s.".formatted(PATIENCE.toSeconds()));
            } else if (error != null) {
                fail(goal, PlanningError.UNKNOWN, "The planner failed: %s".formatted(error.getMessage()));
            } else {
                end(goal, question, result);
            }
        });
    }

    /// From each stop to the next one.
    private static CompletionStage<Result> path(Question question) {
        CompletionStage<Result> all = CompletableFuture.completedStage(new Result.Found(Path2d.EMPTY, 0, 0));
        for (int i = 1; i < question.stops.size(); i++) {
            Pose2d from = question.stops.get(i - 1);
            Pose2d to = question.stops.get(i);
            all = all.thenCompose(before -> before instanceof Result.Found found
                    ? question.planner.plan(from, to).thenApply(next -> joined(found, next))
                    : CompletableFuture.completedStage(before));
        }
        return all;
    }

    private static Result joined(Result.Found before, Result next) {
        return switch (next) {
            case Result.Found(Path2d path, double cost, double offGoal) ->
                new Result.Found(
                        new Path2d(Stream.concat(before.path().points().stream(), path.points().stream())
                                .toList()),
                        before.cost() + cost,
                        offGoal);
            case Result.NoPath none -> none;
        };
    }

    private void end(ServedGoal goal, Question question, Result result) {
        switch (result) {
            case Result.Found(Path2d path, double _, double offGoal) -> {
                List<Pose2d> poses = PathMessage.poses(path);
                if (offGoal == 0 && !poses.isEmpty()) {
                    Pose2d last = poses.removeLast();
                    poses.add(new Pose2d(last.x(), last.y(), question.goal().theta()));
                }
                Duration planning = Duration.between(question.asked, time.ofRun());
                goal.end(Status.SUCCEEDED, writer -> write(writer, poses, planning, 0, ""));
            }
            case Result.NoPath(String why) -> fail(goal, error(question), why);
        }
    }

    /// Planners of ours tell why in words only.
    private PlanningError error(Question question) {
        if (!isInside(question.start())) {
            return PlanningError.START_OUTSIDE_MAP;
        }
        if (!isInside(question.goal())) {
            return PlanningError.GOAL_OUTSIDE_MAP;
        }
        if (isOccupied(question.start())) {
            return PlanningError.START_OCCUPIED;
        }
        return isOccupied(question.goal()) ? PlanningError.GOAL_OCCUPIED : PlanningError.NO_VALID_PATH;
    }

    private boolean isInside(Pose2d place) {
        return map.contains(map.column(place.x()), map.row(place.y()));
    }

    private boolean isOccupied(Pose2d place) {
        return map.at(map.column(place.x()), map.row(place.y())) == OccupancyGrid.OCCUPIED;
    }

    private void fail(ServedGoal goal, PlanningError error, String why) {
        goal.end(Status.ABORTED, writer -> write(writer, List.of(), Duration.ZERO, error.code(), why));
    }

    /// `ComputePathToPose_Result`; Humble reads no more than the time.
    private void write(CdrWriter writer, List<Pose2d> poses, Duration planning, int code, String why) {
        PathMessage.write(writer, time.instant(), MAP, poses);
        writer.int32((int) planning.toSeconds()).int32(planning.toNanosPart());
        writer.int16((short) code).text(why);
    }

    /// What is planned can't be stopped, but nobody waits for it any more.
    @Override
    public void cancel(ServedGoal goal) {
        goal.end(Status.CANCELED, this::writeNoResult);
    }

    @Override
    public void writeNoResult(CdrWriter writer) {
        write(writer, List.of(), Duration.ZERO, 0, "");
    }

    /// Ends all goals.
    void abortAll() {
        server.abortAll();
    }

    void close() {
        server.close();
    }
}
