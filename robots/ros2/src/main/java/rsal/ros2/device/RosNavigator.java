package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.jspecify.annotations.Nullable;
import rsal.data.OccupancyGrid;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Health;
import rsal.device.Navigator;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;

/// A robot's own navigator, such as Nav2's: the action `navigate_to_pose` of the type `nav2_msgs/NavigateToPose`.
///
/// Nav2 has neither a pause nor tolerances of a goal: a paused goal is canceled and sent again, and one within its
/// tolerance is canceled as reached.
final class RosNavigator extends DeviceCore implements Navigator {
    private static final Duration PATIENCE = Duration.ofSeconds(1); // without anybody who serves the action
    private static final String MAP = "map";
    private static final int FIRST_OF_PLANNING = 200; // error codes of Nav2
    private static final int LAST_OF_PLANNING = 399;

    private final ActionClient action;
    private final RosBase base;
    private final Frames frames;
    private final String name;
    private final Supplier<PublicGrid> costTopics;
    private @Nullable PublicGrid costs; // since somebody asked for them
    private @Nullable Drive drive;
    private boolean paused;
    private Instant served = Instant.MIN; // when somebody served the action last

    /// A goal, and how it gets on.
    private static final class Drive implements ActionClient.Listener {
        private final RosNavigator navigator;
        private final Pose2d mapFromGoal;
        private final Tolerance tolerance;
        private final Instant begun;
        private final GoalSource<Progress, Result> goal;
        private ActionClient.@Nullable Goal sent;
        private ActionClient.@Nullable Goal replaced; // which the robot's navigator gives up when it takes this one
        private Pose2d mapFromBase = Pose2d.ORIGIN; // as told last

        Drive(RosNavigator navigator, Pose2d mapFromGoal, Tolerance tolerance, Instant begun) {
            this.navigator = navigator;
            this.mapFromGoal = mapFromGoal;
            this.tolerance = tolerance;
            this.begun = begun;
            this.goal = new GoalSource<>(() -> navigator.cancel(this));
        }

        Duration tried() {
            return Duration.between(begun, navigator.frames.now());
        }

        @Override
        public void onFeedback(RosMessage message) {
            Pose2d pose = FrameTransform.of(message.message("current_pose").message("pose"), "position", "orientation")
                    .planar();
            if (pose.isFinite()) {
                mapFromBase = pose;
                navigator.progress(this, message.number("distance_remaining"));
            }
        }

        @Override
        public void onRefused() {
            sent = null;
            navigator.giveUp(this);
            navigator.end(this, new Result.NoPath("The robot's navigator refused the goal. Is it active?"));
        }

        @Override
        public void onResult(RosMessage response) {
            navigator.end(this, result((int) response.integer("status"), response.message("result")));
        }

        private Result result(int status, RosMessage result) {
            if (status == ActionClient.SUCCEEDED) {
                return new Result.Reached(mapFromGoal);
            }
            if (status == ActionClient.CANCELED) {
                return new Result.Cancelled("The robot's navigator canceled it.");
            }
            boolean tellsWhy = result.fields().containsKey("error_code"); // Humble does not
            long code = tellsWhy ? result.integer("error_code") : 0;
            String why = tellsWhy && !result.text("error_msg").isEmpty()
                    ? "%s (error %d of Nav2)".formatted(result.text("error_msg"), code)
                    : "The robot's navigator gave up (error %d).".formatted(code);
            return code >= FIRST_OF_PLANNING && code <= LAST_OF_PLANNING
                    ? new Result.NoPath(why)
                    : new Result.Stuck(mapFromBase, tried(), why);
        }

        @Override
        public void onFailure(String why) {
            navigator.giveUp(this);
            navigator.end(this, new Result.Stuck(mapFromBase, tried(), why));
        }
    }

    /// @param name of the action, for people
    /// @param costTopics subscribes to the robot's costs
    RosNavigator(
            DeviceInfo info,
            ActionClient action,
            String name,
            RosBase base,
            Frames frames,
            Supplier<PublicGrid> costTopics) {
        super(info);
        this.costTopics = costTopics;
        this.action = action;
        this.name = name;
        this.base = base;
        this.frames = frames;
        base.onMotors(this::motors);
    }

    private void motors(boolean enabled) {
        if (enabled) {
            send();
        } else {
            hold();
        }
    }

    @Override
    public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
        if (!mapFromGoal.isFinite()) {
            throw new IllegalArgumentException("A goal must be finite, not '%s'.".formatted(mapFromGoal));
        }
        Drive before = drive;
        var next = new Drive(this, mapFromGoal, tolerance, frames.now());
        drive = next;
        if (before != null) {
            next.replaced = before.sent;
            before.goal.end(Result.Cancelled.by(mapFromGoal)); // the robot's navigator goes on with the next one
        }
        if (action.isAvailable()) {
            send();
        } else {
            giveUp(next);
            end(next, new Result.Stuck(Pose2d.ORIGIN, Duration.ZERO, "Nobody serves '%s'.".formatted(name)));
        }
        return next.goal;
    }

    /// Unless somebody holds it back.
    private void send() {
        Drive now = drive;
        if (now != null && now.sent == null && !paused && base.enabled()) {
            now.sent = action.send(goal -> write(goal, now.mapFromGoal), now);
        }
    }

    /// `nav2_msgs/NavigateToPose_Goal`, by the behavior tree that is usual there. A time of 0 is the newest.
    private static void write(CdrWriter goal, Pose2d mapFromGoal) {
        goal.int32(0).int32(0).text(MAP);
        RosMessages.write(goal, FrameTransform.of(mapFromGoal)).text("");
    }

    /// So that the robot pursues no goal that nobody here knows of.
    private void giveUp(Drive ended) {
        for (ActionClient.Goal goal : new ActionClient.Goal[] {ended.replaced, ended.sent}) {
            if (goal != null) {
                action.cancel(goal);
            }
        }
        ended.replaced = null;
        ended.sent = null;
    }

    private void hold() {
        if (drive != null && drive.sent != null) {
            action.cancel(drive.sent);
            drive.sent = null;
        }
    }

    private void cancel(Drive old) {
        if (old.equals(drive)) {
            hold();
            end(old, Result.Cancelled.asked());
        }
    }

    private void end(Drive ended, Result result) {
        if (ended.equals(drive)) {
            drive = null;
            ended.goal.end(result);
        }
    }

    private void progress(Drive now, double remaining) {
        if (!now.equals(drive)) {
            return;
        }
        if (now.mapFromBase.isNear(now.mapFromGoal, now.tolerance.distance(), now.tolerance.angle())) {
            hold();
            end(now, new Result.Reached(now.mapFromBase));
        } else {
            now.goal.publish(new Stamped<>(
                    frames.now(),
                    MAP,
                    new Progress(now.mapFromBase, remaining, now.mapFromGoal.position(), now.tried())));
        }
    }

    /// Looks whether there is still somebody who serves the action.
    void look(Instant now) {
        action.look(now);
        if (action.isAvailable()) {
            served = now;
            health(Health.ok());
        } else if (served.equals(Instant.MIN) || served.plus(PATIENCE).isBefore(now)) {
            String why = "Nobody serves '%s'.".formatted(name);
            health(new Health.Lost(why));
            if (drive != null) {
                giveUp(drive);
                end(drive, new Result.Stuck(drive.mapFromBase, drive.tried(), why));
            }
        }
    }

    @Override
    public void pause() {
        paused = true;
        hold();
    }

    @Override
    public void resume() {
        paused = false;
        send();
    }

    @Override
    public boolean paused() {
        return paused;
    }

    @Override
    public Optional<Pose2d> goal() {
        return Optional.ofNullable(drive).map(now -> now.mapFromGoal);
    }

    /// Straight on, as the robot's navigator keeps its way to itself.
    @Override
    public Path2d path() {
        return drive == null || drive.sent == null
                ? Path2d.EMPTY
                : new Path2d(List.of(drive.mapFromBase.position(), drive.mapFromGoal.position()));
    }

    /// The first call subscribes to them, since costmaps are large.
    @Override
    public Optional<OccupancyGrid> costMap() {
        if (costs == null) {
            costs = costTopics.get();
        }
        return costs.publishers() > 0 ? costs.newest() : Optional.empty();
    }

    /// Stops what it drives, for good.
    void end() {
        if (costs != null) {
            costs.close();
        }
        hold();
        if (drive != null) {
            end(drive, new Result.Cancelled("The connection to the robot is closed."));
        }
        action.close();
    }
}
