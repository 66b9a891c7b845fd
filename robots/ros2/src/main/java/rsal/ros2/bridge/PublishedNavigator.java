package rsal.ros2.bridge;

import java.time.Duration;
import java.util.HashMap;
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
import rsal.ros2.action.Services;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.PlanningError;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.StampedPose;
import rsal.ros2.simulation.PublishedTime;

/// A navigator of ours as Nav2's action `navigate_to_pose`, as it is in Jazzy and Kilted. A new goal takes
/// the place of the one before, which is aborted, as Nav2 does it.
final class PublishedNavigator implements ActionServer.Handler {
    private static final Tolerance TOLERANCE = new Tolerance(0.25, 0.25); // m, rad; those that Nav2 has
    private static final int NO_PATH = PlanningError.NO_VALID_PATH.code();
    private static final String MAP = "map";

    private final Navigator navigator;
    private final PublishedTime time;
    private final ActionServer server;
    private final Map<ServedGoal, GoalHandle<Progress, Result>> drives = new HashMap<>();

    /// @param services which this closes
    PublishedNavigator(Navigator navigator, RosLink link, Services services, String name, PublishedTime time) {
        this.navigator = navigator;
        this.time = time;
        server = new ActionServer(link, services, name, "nav2_msgs/action/NavigateToPose", time, this);
    }

    @Override
    public void begin(ServedGoal goal, RosMessage fields) {
        Optional<Pose2d> mapFromGoal = StampedPose.onMap(fields.message("pose"));
        if (mapFromGoal.isEmpty()) {
            goal.end(Status.ABORTED, result(NO_PATH, "A goal must be finite, and in the frame 'map'."));
            return;
        }
        GoalHandle<Progress, Result> drive = navigator.goTo(mapFromGoal.get(), TOLERANCE);
        drives.put(goal, drive);
        drive.onFeedback(reported -> goal.publishFeedback(writer -> write(writer, reported)));
        drive.result().thenAccept(ending -> {
            drives.remove(goal);
            NavigationEnding end = NavigationEnding.of(ending, goal.isCanceling());
            goal.end(end.status(), result(end.code(), end.why()));
        });
    }

    /// `NavigateToPose_Result`
    private static Consumer<CdrWriter> result(int code, String why) {
        return writer -> writer.int16((short) code).text(why);
    }

    /// `NavigateToPose_Feedback`
    private void write(CdrWriter writer, Stamped<Progress> reported) {
        Progress progress = reported.value();
        RosMessages.write(writer, time.stamp(reported.time())).text(MAP);
        RosMessages.write(writer, FrameTransform.of(progress.mapFromBase()));
        Duration driving = progress.driving();
        writer.int32((int) driving.toSeconds()).int32(driving.toNanosPart());
        writer.int32(0).int32(0); // how long it will still take is not known
        writer.int16((short) 0).float32((float) progress.remaining());
    }

    @Override
    public void cancel(ServedGoal goal) {
        GoalHandle<Progress, Result> drive = drives.get(goal);
        if (drive != null) {
            drive.cancel();
        }
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
