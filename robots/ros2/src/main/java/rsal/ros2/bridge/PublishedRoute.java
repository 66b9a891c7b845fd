package rsal.ros2.bridge;

import java.time.Duration;
import java.time.Instant;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.function.Consumer;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.device.GoalHandle;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.device.Navigator.Tolerance;
import rsal.ros2.action.ActionServer;
import rsal.ros2.action.ActionServer.ServedGoal;
import rsal.ros2.action.ActionServer.Status;
import rsal.ros2.action.RequestVersions;
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.StampedPose;
import rsal.ros2.simulation.PublishedTime;

/// A navigator of ours as Nav2's action `navigate_through_poses`, one pose after another; near a pose that is not the
/// last it goes on to the next one without a stop. Goals are those of all distributions. Feedback and results are
/// those of Kilted: those of Humble and Jazzy are the beginning of them.
final class PublishedRoute implements ActionServer.Handler {
    private static final String ACTION = "nav2_msgs/action/NavigateThroughPoses";
    private static final double PASSED = 0.7; // m; as Nav2's own behavior tree has it
    private static final Tolerance BETWEEN = Tolerance.position(PASSED / 2);
    private static final Tolerance LAST = new Tolerance(0.25, 0.25); // m, rad; those that Nav2 has
    private static final int MOST_POSES = 100;
    private static final int UNKNOWN = 9100; // error codes of Nav2
    private static final int TF_ERROR = 9102;
    private static final String MAP = "map";

    private final Navigator navigator;
    private final PublishedTime time;
    private final ActionServer server;
    private final Map<ServedGoal, Route> routes = new HashMap<>();

    /// How a pose of a route is (`nav2_msgs/WaypointStatus`).
    private enum Waypoint {
        PENDING(0),
        COMPLETED(1),
        FAILED(3);

        private final byte code;

        Waypoint(int code) {
            this.code = (byte) code;
        }
    }

    /// @param services which this closes
    PublishedRoute(Navigator navigator, RosLink link, Services services, String name, PublishedTime time) {
        this.navigator = navigator;
        this.time = time;
        server = new ActionServer(link, services, name, ACTION, RequestVersions.of(ACTION + "_SendGoal"), time, this);
    }

    @Override
    public void begin(ServedGoal goal, RosMessage fields) {
        List<RosMessage> places = fields.fields().get("poses") instanceof RosMessage goals // since Kilted
                ? goals.messages("goals")
                : fields.messages("poses");
        List<Pose2d> onMap = places.stream()
                .map(StampedPose::onMap)
                .flatMap(Optional::stream)
                .toList();
        if (places.isEmpty() || places.size() > MOST_POSES) {
            String why = "A route must have 1 to %d poses, not %d.".formatted(MOST_POSES, places.size());
            goal.end(Status.ABORTED, result(UNKNOWN, why));
        } else if (onMap.size() < places.size()) {
            goal.end(Status.ABORTED, result(TF_ERROR, "Poses must be finite, and in the frame 'map'."));
        } else {
            var route = new Route(goal, onMap);
            routes.put(goal, route);
            route.drive();
        }
    }

    /// A goal under way.
    private final class Route {
        private final ServedGoal goal;
        private final List<Pose2d> poses;
        private final Instant begun = time.ofRun();
        private Optional<GoalHandle<Progress, Result>> leg = Optional.empty(); // to the next pose
        private int next;

        Route(ServedGoal goal, List<Pose2d> poses) {
            this.goal = goal;
            this.poses = poses;
        }

        private boolean isLast() {
            return next == poses.size() - 1;
        }

        /// The leg before, whose place this one takes, has no ending any more.
        void drive() {
            leg = Optional.empty();
            GoalHandle<Progress, Result> now = navigator.goTo(poses.get(next), isLast() ? LAST : BETWEEN);
            leg = Optional.of(now);
            now.onFeedback(reported -> {
                if (isNow(now)) {
                    publish(reported);
                }
            });
            now.result().thenAccept(ending -> {
                if (isNow(now)) {
                    end(ending);
                }
            });
        }

        private boolean isNow(GoalHandle<Progress, Result> handle) {
            return leg.filter(handle::equals).isPresent();
        }

        private void publish(Stamped<Progress> reported) {
            goal.publishFeedback(writer -> write(writer, reported));
            if (!isLast() && reported.value().mapFromBase().distanceTo(poses.get(next)) < PASSED) {
                next++;
                drive();
            }
        }

        private void end(Result ending) {
            if (ending instanceof Result.Reached && !isLast()) {
                next++;
                drive();
                return;
            }
            leg = Optional.empty();
            routes.remove(goal);
            NavigationEnding end = NavigationEnding.of(ending, goal.isCanceling());
            boolean isReached = end.status() == Status.SUCCEEDED;
            goal.end(end.status(), writer -> {
                writer.int16((short) end.code()).text(end.why());
                write(writer, isReached ? Waypoint.COMPLETED : Waypoint.FAILED);
            });
        }

        void cancel() {
            leg.ifPresent(GoalHandle::cancel);
        }

        /// `NavigateThroughPoses_Feedback`
        private void write(CdrWriter writer, Stamped<Progress> reported) {
            Progress progress = reported.value();
            RosMessages.write(writer, time.stamp(reported.time())).text(MAP);
            RosMessages.write(writer, FrameTransform.of(progress.mapFromBase()));
            Duration driving = Duration.between(begun, reported.time());
            writer.int32((int) driving.toSeconds()).int32(driving.toNanosPart());
            writer.int32(0).int32(0); // how long it will still take is not known
            writer.int16((short) 0).float32((float) remaining(progress)).int16((short) (poses.size() - next));
            write(writer, Waypoint.PENDING);
        }

        /// The way to the next pose, and straight on from there [m].
        private double remaining(Progress progress) {
            double remaining = progress.remaining();
            for (int i = next + 1; i < poses.size(); i++) {
                remaining += poses.get(i).distanceTo(poses.get(i - 1));
            }
            return remaining;
        }

        /// `nav2_msgs/WaypointStatus` of all poses.
        private void write(CdrWriter writer, Waypoint present) {
            writer.int32(poses.size());
            for (int i = 0; i < poses.size(); i++) {
                Waypoint status = i < next ? Waypoint.COMPLETED : i == next ? present : Waypoint.PENDING;
                writer.int8(status.code).int32(i);
                RosMessages.write(writer, time.stamp(begun)).text(MAP);
                RosMessages.write(writer, FrameTransform.of(poses.get(i)));
                writer.int16((short) 0).text("");
            }
        }
    }

    /// `NavigateThroughPoses_Result` without poses
    private static Consumer<CdrWriter> result(int code, String why) {
        return writer -> writer.int16((short) code).text(why).int32(0);
    }

    @Override
    public void cancel(ServedGoal goal) {
        Optional.ofNullable(routes.get(goal)).ifPresent(Route::cancel);
    }

    @Override
    public void writeNoResult(CdrWriter writer) {
        result(0, "").accept(writer);
    }

    /// Ends all goals.
    void abortAll() {
        server.abortAll();
    }

    void close() {
        server.close();
    }
}
