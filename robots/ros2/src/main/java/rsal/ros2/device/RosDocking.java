package rsal.ros2.device;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.jspecify.annotations.Nullable;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Docking;
import rsal.device.GoalHandle;
import rsal.device.GoalSource;
import rsal.device.Health;
import rsal.ros2.action.ActionClient;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Docking by Nav2's docking server: the actions `dock_robot` and `undock_robot`, whose types are the same in all
/// distributions that have them.
final class RosDocking extends DeviceCore implements Docking {
    static final String DOCK = "nav2_msgs/action/DockRobot";

    private static final String UNDOCK = "nav2_msgs/action/UndockRobot";
    private static final Duration PATIENCE = Duration.ofSeconds(1); // without anybody who serves the actions
    private static final float LONGEST_APPROACH = 1_000; // s, what Nav2 has
    private static final float LONGEST_UNDOCKING = 30; // s, what Nav2 has
    private static final String MAP = "map";
    private static final Map<Integer, String> ERRORS = Map.of(
            901, "it knows no such dock",
            902, "it can't use this dock",
            903, "it did not get to the place in front of the dock",
            904, "it did not detect the dock",
            905, "it did not get onto the dock, or off it",
            906, "the dock does not charge it",
            907, "it took too long");

    private final ActionClient docking;
    private final ActionClient undocking;
    private final String name;
    private final RosBase base;
    private final Frames frames;
    private @Nullable Attempt attempt;
    private Instant served = Instant.MIN; // when somebody served docking last

    /// A goal under way.
    private static final class Attempt implements ActionClient.Listener {
        private final RosDocking device;
        private final ActionClient action;
        private final Instant begun;
        private final GoalSource<Progress, Result> goal;
        private ActionClient.@Nullable Goal sent;

        Attempt(RosDocking device, ActionClient action) {
            this.device = device;
            this.action = action;
            this.begun = device.frames.now();
            this.goal = new GoalSource<>(() -> device.cancel(this, "It was asked to."));
        }

        /// That of undocking has no fields.
        @Override
        public void onFeedback(RosMessage message) {
            if (action.equals(device.docking)) {
                device.publish(this, stage((int) message.integer("state")), (int) message.integer("num_retries"));
            }
        }

        /// Constants of `DockRobot_Feedback`.
        private static Stage stage(int state) {
            return switch (state) {
                case 1 -> Stage.APPROACHING;
                case 2 -> Stage.DETECTING;
                case 3 -> Stage.MOVING;
                case 4 -> Stage.WAITING;
                case 5 -> Stage.RETRYING;
                default -> Stage.BEGINNING;
            };
        }

        /// The docking server tells only when it begins with something else.
        @Override
        public boolean tellsSteadily() {
            return false;
        }

        @Override
        public void onRefused() {
            device.end(this, new Result.Failed("The robot's docking server refused the goal. Is it active?"));
        }

        @Override
        public void onResult(RosMessage response) {
            device.end(this, result((int) response.integer("status"), response.message("result")));
        }

        private static Result result(int status, RosMessage result) {
            if (status == ActionClient.SUCCEEDED && result.get("success", Boolean.class)) {
                return new Result.Reached();
            }
            if (status == ActionClient.CANCELED) {
                return new Result.Cancelled("The robot's docking server canceled it.");
            }
            int code = (int) result.integer("error_code");
            String reported = result.text("error_msg");
            return new Result.Failed("The robot gave up: %s (error %d of Nav2)."
                    .formatted(reported.isEmpty() ? ERRORS.getOrDefault(code, "it does not say why") : reported, code));
        }

        @Override
        public void onFailure(String why) {
            device.giveUp(this);
            device.end(this, new Result.Failed(why));
        }
    }

    /// @param dock the action that docks, with its namespace
    /// @param undock the one that undocks
    RosDocking(DeviceInfo info, String dock, String undock, RosContext context) {
        super(info);
        TypeLibrary types = TypeLibrary.of(Distribution.JAZZY);
        name = dock;
        docking = new ActionClient(context.link(), types, dock, DOCK, context.scheduler(), context.random());
        undocking = new ActionClient(context.link(), types, undock, UNDOCK, context.scheduler(), context.random());
        base = context.base();
        frames = context.frames();
        base.onMotors(this::motors);
    }

    private void motors(boolean enabled) {
        if (!enabled && attempt != null) {
            cancel(attempt, "The motors of the robot are off.");
        }
    }

    @Override
    public GoalHandle<Progress, Result> dock(String dock) {
        return begin(docking, goal -> write(goal, dock, Pose2d.ORIGIN, ""));
    }

    @Override
    public GoalHandle<Progress, Result> dock(Pose2d mapFromDock, String type) {
        if (!mapFromDock.isFinite()) {
            throw new IllegalArgumentException("A dock must be at a finite place, not '%s'.".formatted(mapFromDock));
        }
        return begin(docking, goal -> write(goal, "", mapFromDock, type));
    }

    /// `nav2_msgs/DockRobot_Goal`. A time of 0 is the newest.
    ///
    /// @param dock empty where its place counts
    private static void write(CdrWriter goal, String dock, Pose2d mapFromDock, String type) {
        goal.bool(!dock.isEmpty()).text(dock).int32(0).int32(0).text(MAP);
        RosMessages.write(goal, FrameTransform.of(mapFromDock)).text(type);
        goal.float32(LONGEST_APPROACH).bool(true);
    }

    @Override
    public GoalHandle<Progress, Result> undock() {
        return begin(undocking, goal -> goal.text("").float32(LONGEST_UNDOCKING));
    }

    private GoalHandle<Progress, Result> begin(ActionClient action, Consumer<CdrWriter> fields) {
        if (attempt != null) {
            cancel(attempt, "Another goal was given.");
        }
        var next = new Attempt(this, action);
        attempt = next;
        if (!base.enabled()) {
            end(next, new Result.Failed("The motors of the robot are off."));
        } else if (!action.isAvailable()) {
            end(next, new Result.Failed("Nobody serves '%s'.".formatted(action.name())));
        } else {
            next.sent = action.send(fields, next);
        }
        return next.goal;
    }

    private void publish(Attempt now, Stage stage, int retries) {
        if (now.equals(attempt)) {
            now.goal.publish(new Stamped<>(
                    frames.now(), MAP, new Progress(stage, retries, Duration.between(now.begun, frames.now()))));
        }
    }

    private void cancel(Attempt old, String why) {
        giveUp(old);
        end(old, new Result.Cancelled(why));
    }

    /// So that the robot pursues no goal that nobody here knows of.
    private void giveUp(Attempt old) {
        if (old.sent != null) {
            old.action.cancel(old.sent);
            old.sent = null;
        }
    }

    private void end(Attempt ended, Result result) {
        if (ended.equals(attempt)) {
            attempt = null;
            ended.goal.end(result);
        }
    }

    /// Looks whether there is still somebody who serves the actions.
    void look(Instant now) {
        for (ActionClient action : List.of(docking, undocking)) {
            action.look(now);
        }
        if (docking.isAvailable()) {
            served = now;
            health(Health.ok());
        } else if (served.equals(Instant.MIN) || served.plus(PATIENCE).isBefore(now)) {
            String why = "Nobody serves '%s'.".formatted(name);
            health(new Health.Lost(why));
            if (attempt != null) {
                giveUp(attempt);
                end(attempt, new Result.Failed(why));
            }
        }
    }

    /// Stops what it does, for good.
    void end() {
        if (attempt != null) {
            cancel(attempt, "The connection to the robot is closed.");
        }
        docking.close();
        undocking.close();
    }
}
