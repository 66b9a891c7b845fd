package rsal.ros2.bridge;

import java.time.Duration;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import java.util.function.Supplier;
import rsal.data.Pose2d;
import rsal.device.Docking;
import rsal.device.Docking.Progress;
import rsal.device.Docking.Result;
import rsal.device.GoalHandle;
import rsal.ros2.action.ActionServer;
import rsal.ros2.action.ActionServer.ServedGoal;
import rsal.ros2.action.ActionServer.Status;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink;
import rsal.ros2.message.StampedPose;
import rsal.ros2.simulation.PublishedTime;

/// Docking of ours as Nav2's actions `dock_robot` and `undock_robot`. A new goal takes the place of the one before,
/// which is aborted.
final class PublishedDocking {
    private static final int UNKNOWN = 999; // DockRobot_Result, UndockRobot_Result
    private static final int NOT_VALID = 902;

    private final Docking docking;
    private final Server dock;
    private final Server undock;

    /// What begins a goal.
    private interface Beginning {
        /// @return empty when its fields make no sense
        Optional<GoalHandle<Progress, Result>> begin(RosMessage fields);
    }

    /// One of the two actions.
    private static final class Server implements ActionServer.Handler {
        private final Beginning beginning;
        private final boolean isDocking; // whose feedback and result have more fields
        private final ActionServer server;
        private final Map<ServedGoal, GoalHandle<Progress, Result>> attempts = new HashMap<>();

        Server(
                RosLink link,
                Services services,
                String name,
                PublishedTime scheduler,
                boolean isDocking,
                Beginning beginning) {
            this.beginning = beginning;
            this.isDocking = isDocking;
            String type = isDocking ? "nav2_msgs/action/DockRobot" : "nav2_msgs/action/UndockRobot";
            server = new ActionServer(link, services, name, type, scheduler, this);
        }

        @Override
        public void begin(ServedGoal goal, RosMessage fields) {
            Optional<GoalHandle<Progress, Result>> begun = beginning.begin(fields);
            if (begun.isEmpty()) {
                goal.end(
                        Status.ABORTED,
                        result(NOT_VALID, "A dock must have a name, or a finite pose in the frame 'map'."));
                return;
            }
            GoalHandle<Progress, Result> attempt = begun.get();
            attempts.put(goal, attempt);
            attempt.onFeedback(reported -> goal.publishFeedback(writer -> write(writer, reported.value())));
            attempt.result().thenAccept(ending -> {
                attempts.remove(goal);
                end(goal, ending);
            });
        }

        private void end(ServedGoal goal, Result ending) {
            switch (ending) {
                case Result.Reached _ -> goal.end(Status.SUCCEEDED, result(0, ""));
                case Result.Cancelled(String why) ->
                    goal.end(goal.isCanceling() ? Status.CANCELED : Status.ABORTED, result(0, why));
                case Result.Failed(String why) -> goal.end(Status.ABORTED, result(UNKNOWN, why));
            }
        }

        private void write(CdrWriter writer, Progress progress) {
            if (!isDocking) {
                writer.int8((byte) 0); // a message without fields
                return;
            }
            Duration working = progress.working();
            writer.int16(state(progress.stage()))
                    .int32((int) working.toSeconds())
                    .int32(working.toNanosPart())
                    .int16((short) progress.retries());
        }

        /// Constants of `DockRobot_Feedback`.
        private static short state(Docking.Stage stage) {
            return (short)
                    switch (stage) {
                        case BEGINNING -> 0;
                        case APPROACHING -> 1;
                        case DETECTING -> 2;
                        case MOVING -> 3;
                        case WAITING -> 4;
                        case RETRYING -> 5;
                    };
        }

        private Consumer<CdrWriter> result(int code, String why) {
            boolean isDone = code == 0 && why.isEmpty();
            return writer -> {
                writer.bool(isDone).int16((short) code);
                if (isDocking) {
                    writer.int16((short) 0); // retries
                }
                writer.text(why);
            };
        }

        @Override
        public void cancel(ServedGoal goal) {
            Optional.ofNullable(attempts.get(goal)).ifPresent(GoalHandle::cancel);
        }

        @Override
        public void writeNoResult(CdrWriter writer) {
            result(UNKNOWN, "").accept(writer);
        }
    }

    /// @param services makes new ones, which this closes
    /// @param dock the name of the action that docks, with its namespace
    /// @param undock of the one that undocks
    PublishedDocking(
            Docking docking,
            RosLink link,
            Supplier<Services> services,
            String dock,
            String undock,
            PublishedTime scheduler) {
        this.docking = docking;
        this.dock = new Server(link, services.get(), dock, scheduler, true, this::dock);
        this.undock = new Server(link, services.get(), undock, scheduler, false, _ -> Optional.of(docking.undock()));
    }

    private Optional<GoalHandle<Progress, Result>> dock(RosMessage fields) {
        if (fields.get("use_dock_id", Boolean.class)) {
            return Optional.of(fields.text("dock_id"))
                    .filter(name -> !name.isEmpty())
                    .map(docking::dock);
        }
        Optional<Pose2d> mapFromDock = StampedPose.onMap(fields.message("dock_pose"));
        return mapFromDock.map(pose -> docking.dock(pose, fields.text("dock_type")));
    }

    /// Ends all goals.
    void abortAll() {
        dock.server.abortAll();
        undock.server.abortAll();
    }

    void close() {
        dock.server.close();
        undock.server.close();
    }
}
