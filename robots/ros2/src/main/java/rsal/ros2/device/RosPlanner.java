package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.jspecify.annotations.Nullable;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Health;
import rsal.device.Planner;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.PathMessage;
import rsal.ros2.message.PlanningError;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.StampedPose;

/// A robot's own planner, such as Nav2's planner server: the action `compute_path_to_pose`.
///
/// Nav2 works on one goal at a time, and a second one may end the first: so requests wait here for each other. It
/// tells no costs; a path costs its length.
final class RosPlanner extends DeviceCore implements Planner {
    static final String ACTION = "nav2_msgs/action/ComputePathToPose";

    private static final Duration PATIENCE = Duration.ofSeconds(1); // without anybody who serves the action
    private static final Duration ANSWER = Duration.ofSeconds(10); // for a path
    private static final int MOST_WAITING = 1_000; // requests
    private static final int TRIES = 3; // of a request that another program's goal ended
    private static final int MOST_UNANSWERED = 3; // requests in a row, before all that wait end
    private static final double ON_GOAL = 0.1; // m; a path on a grid ends in the middle of a cell
    private static final String MAP = "map";

    private final String name;
    private final RosContext context;
    private final ActionClient action;
    private final MessageCodec codec;
    private final Deque<Request> waiting = new ArrayDeque<>();
    private @Nullable Request pending; // the one that the robot works on
    private @Nullable Stamped<Asked> latest;
    private int unanswered; // requests in a row
    private Instant served = Instant.MIN; // when somebody served the action last

    /// Somebody who waits for a path.
    private final class Request implements ActionClient.Listener {
        private final Pose2d mapFromStart;
        private final Pose2d mapFromGoal;
        private final Instant asked = context.scheduler().instant();
        private final CompletableFuture<Result> answer = new CompletableFuture<>();
        private Instant begun = Instant.MAX;
        private int tries;
        private ActionClient.@Nullable Goal sent;

        Request(Pose2d mapFromStart, Pose2d mapFromGoal) {
            this.mapFromStart = mapFromStart;
            this.mapFromGoal = mapFromGoal;
        }

        void send() {
            tries++;
            begun = context.scheduler().instant();
            sent = action.send(writer -> codec.write(goal(), writer), this);
        }

        /// `ComputePathToPose_Goal` by the planner that is usual there, whatever else it has in the robot's
        /// distribution. A time of 0 is the newest.
        private RosMessage goal() {
            RosMessage zero = codec.zero();
            return zero.with("goal", StampedPose.of(zero.message("goal"), MAP, mapFromGoal))
                    .with("start", StampedPose.of(zero.message("start"), MAP, mapFromStart))
                    .with("use_start", true);
        }

        @Override
        public void onFeedback(RosMessage message) {
            // it has no fields
        }

        @Override
        public void onRefused() {
            unanswered = 0;
            end(this, new Result.NoPath("The robot's planner refused the request. Is it active?"));
        }

        @Override
        public void onResult(RosMessage response) {
            unanswered = 0;
            RosMessage result = response.message("result");
            boolean isReplaced = response.integer("status") == ActionClient.ABORTED
                    && result.fields().containsKey("error_code")
                    && result.integer("error_code") == 0;
            if (isReplaced && tries < TRIES) {
                send();
            } else {
                end(this, result((int) response.integer("status"), result));
            }
        }

        private Result result(int status, RosMessage result) {
            if (status != ActionClient.SUCCEEDED) {
                return new Result.NoPath(why(result));
            }
            RosMessage path = result.message("path");
            String frame = path.message("header").text("frame_id");
            if (!RosMessages.frame(frame).equals(MAP)) {
                return new Result.NoPath(
                        "The robot's planner answered in the frame '%s' instead of 'map'.".formatted(frame));
            }
            Path2d found = PathMessage.of(path).orElse(Path2d.EMPTY);
            if (found.points().isEmpty()) {
                return new Result.NoPath(
                        "The path of the robot's planner is empty, or has coordinates without a value.");
            }
            double off = found.points().getLast().distanceTo(mapFromGoal.position());
            return new Result.Found(found, found.length(), off > ON_GOAL ? off : 0);
        }

        private static String why(RosMessage result) {
            if (!result.fields().containsKey("error_code")) {
                return "The robot's planner found no path."; // Humble tells no more
            }
            long code = result.integer("error_code");
            String why = result.text("error_msg").isEmpty()
                    ? PlanningError.of(code).orElse(PlanningError.UNKNOWN).words()
                    : result.text("error_msg");
            return "%s (error %d of Nav2)".formatted(why, code);
        }

        @Override
        public void onFailure(String why) {
            giveUp(this, why);
        }
    }

    /// @param name of the action, with its namespace
    RosPlanner(DeviceInfo info, String name, RosContext context) {
        super(info);
        this.name = name;
        this.context = context;
        action = context.action(name, ACTION);
        codec = MessageCodec.of(context.types().get(ACTION + "_Goal"), context.types());
    }

    @Override
    public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
        var request = new Request(mapFromStart, mapFromGoal);
        if (!mapFromStart.isFinite() || !mapFromGoal.isFinite()) {
            answer(request, new Result.NoPath("The start or the goal has coordinates without a value."));
        } else if (!action.isAvailable()) {
            answer(request, new Result.NoPath(nobody()));
        } else if (waiting.size() >= MOST_WAITING) {
            answer(request, new Result.NoPath("%d requests wait for the robot's planner.".formatted(MOST_WAITING)));
        } else {
            waiting.addLast(request);
            next();
        }
        return request.answer;
    }

    private String nobody() {
        return "Nobody serves '%s'.".formatted(name);
    }

    private void next() {
        if (pending == null && !waiting.isEmpty()) {
            pending = waiting.removeFirst();
            pending.send();
        }
    }

    /// The first ending counts.
    private void end(Request ended, Result result) {
        if (ended.equals(pending)) {
            pending = null;
            answer(ended, result);
            next();
        }
    }

    private void answer(Request request, Result result) {
        if (latest == null || !request.asked.isBefore(latest.time())) {
            latest = new Stamped<>(request.asked, MAP, Asked.of(request.mapFromStart, request.mapFromGoal, result));
        }
        request.answer.complete(result);
    }

    private void giveUp(Request lost, String why) {
        if (lost.sent != null) {
            action.cancel(lost.sent);
        }
        end(lost, new Result.NoPath(why));
    }

    @Override
    public Optional<Stamped<Asked>> latest() {
        return Optional.ofNullable(latest);
    }

    /// Looks whether there is still somebody who serves the action, and answers. After three requests in a row
    /// without an answer, those that wait get none either: each of them would wait as long.
    void look(Instant now) {
        action.look(now);
        Request late = pending;
        if (late != null && late.begun.plus(ANSWER).isBefore(now)) {
            String why = "The robot's planner found no path within %d s.".formatted(ANSWER.toSeconds());
            if (++unanswered < MOST_UNANSWERED) {
                giveUp(late, why);
            } else {
                giveUpAll(why);
            }
        }
        if (action.isAvailable()) {
            served = now;
            health(Health.ok());
        } else if (served.equals(Instant.MIN) || served.plus(PATIENCE).isBefore(now)) {
            health(new Health.Lost(nobody()));
            giveUpAll(nobody());
        }
    }

    private void giveUpAll(String why) {
        List<Request> all = List.copyOf(waiting);
        waiting.clear();
        if (pending != null) {
            giveUp(pending, why);
        }
        all.forEach(request -> answer(request, new Result.NoPath(why)));
    }

    /// For good.
    void end() {
        giveUpAll("The connection to the robot is closed.");
        action.close();
    }
}
