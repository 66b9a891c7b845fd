package rsal.ros2.action;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;

/// Offers an action of ROS 2: takes goals, tells how they get on and how they ended. All but the arrival of
/// requests is on the run's thread.
public final class ActionServer {
    /// States of `action_msgs/GoalStatus`.
    public enum Status {
        UNKNOWN(0),
        EXECUTING(2),
        CANCELING(3),
        SUCCEEDED(4),
        CANCELED(5),
        ABORTED(6);

        private final byte code;

        Status(int code) {
            this.code = (byte) code;
        }
    }

    private static final Duration KEPT = Duration.ofSeconds(15); // results of goals that have ended; rcl has 10 s
    private static final int MOST_GOALS = 100; // known at a time
    private static final int ID = 16; // bytes

    private final ActionTime time;
    private final Handler handler;
    private final Publication feedback;
    private final Publication statuses;
    private final List<Runnable> ends = new ArrayList<>();
    private final Map<String, ServedGoal> goals = new LinkedHashMap<>(); // by id

    /// What is done about goals.
    public interface Handler {
        /// A goal has come, which was accepted.
        ///
        /// @param goal the goal's fields
        void begin(ServedGoal goal, RosMessage fields);

        /// Somebody wants it to be given up.
        void cancel(ServedGoal goal);

        /// Writes the result behind the status, for one that nobody knows.
        void writeNoResult(CdrWriter writer);
    }

    /// A goal of somebody else.
    public final class ServedGoal {
        private final byte[] id;
        private final Instant began = time.ofRun(); // which nobody resets
        private final CompletableFuture<byte[]> result = new CompletableFuture<>();
        private Status status = Status.EXECUTING;
        private Instant forgotten = Instant.MAX; // also

        private ServedGoal(byte[] id) {
            this.id = id;
        }

        /// Whether somebody wants it to be given up.
        public boolean isCanceling() {
            return status == Status.CANCELING;
        }

        private Instant stamp() {
            return time.stamp(began);
        }

        boolean ended() {
            return result.isDone();
        }

        /// @param fields writes the feedback's
        public void publishFeedback(Consumer<CdrWriter> fields) {
            CdrWriter writer = new CdrWriter().int8s(id);
            fields.accept(writer);
            feedback.publish(writer.toBytes());
        }

        /// The first ending counts.
        ///
        /// @param fields writes the result's
        public void end(Status ending, Consumer<CdrWriter> fields) {
            if (!ended()) {
                status = ending;
                forgotten = time.ofRun().plus(KEPT);
                CdrWriter writer = new CdrWriter().int8(ending.code);
                fields.accept(writer);
                result.complete(writer.toBytes());
                publish();
            }
        }
    }

    /// @param name with its namespace: `/robot1/navigate_to_pose`
    /// @param type `nav2_msgs/action/NavigateToPose`
    /// @param services of its own, which it closes
    public ActionServer(RosLink link, Services services, String name, String type, ActionTime time, Handler handler) {
        this(link, services, name, type, services.codec(type + "_SendGoal")::read, time, handler);
    }

    /// As above, of a type whose goals differ between distributions.
    ///
    /// @param requests reads those that send goals
    public ActionServer(
            RosLink link,
            Services services,
            String name,
            String type,
            Inbox.Decoder<RosMessage> requests,
            ActionTime time,
            Handler handler) {
        this.time = time;
        this.handler = handler;
        feedback = link.advertise(new RosTopic(name + "/_action/feedback", type + "_FeedbackMessage"), Profile.DEFAULT);
        statuses = link.advertise(
                new RosTopic(name + "/_action/status", "action_msgs/msg/GoalStatusArray"), Profile.LATCHED);
        ends.add(feedback::close);
        ends.add(statuses::close);
        services.serve(name + "/_action/send_goal", type + "_SendGoal", requests, (request, _) -> send(request));
        services.serveLater(name + "/_action/get_result", type + "_GetResult", this::result);
        services.serveLater(name + "/_action/cancel_goal", "action_msgs/srv/CancelGoal", this::cancel);
        ends.add(services::close);
        ends.add(time.every(Duration.ofSeconds(1), this::forget)::cancel);
    }

    private static String id(RosMessage named) {
        return HexFormat.of().formatHex(Arrays.copyOf(named.message("goal_id").get("uuid", byte[].class), ID));
    }

    private CompletionStage<byte[]> send(RosMessage request) {
        String id = id(request);
        if (goals.size() >= MOST_GOALS) {
            forgetOldest();
        }
        boolean accepted = goals.size() < MOST_GOALS && !goals.containsKey(id);
        if (accepted) {
            var goal = new ServedGoal(HexFormat.of().parseHex(id));
            goals.put(id, goal);
            publish();
            handler.begin(goal, request.message("goal"));
        }
        CdrWriter response = RosMessages.write(new CdrWriter().bool(accepted), time.instant());
        return CompletableFuture.completedStage(response.toBytes());
    }

    private CompletionStage<byte[]> result(RosMessage request) {
        ServedGoal goal = goals.get(id(request));
        if (goal != null) {
            return goal.result;
        }
        CdrWriter writer = new CdrWriter().int8(Status.UNKNOWN.code);
        handler.writeNoResult(writer);
        return CompletableFuture.completedStage(writer.toBytes());
    }

    /// One goal, or all where neither an id nor a time is given (`action_msgs/CancelGoal`); those up to a
    /// time, too.
    private CompletionStage<byte[]> cancel(RosMessage request) {
        RosMessage info = request.message("goal_info");
        String id = id(info);
        RosMessage until = info.message("stamp");
        Instant stamp = Instant.ofEpochSecond(until.integer("sec"), until.integer("nanosec"));
        boolean isOne = !id.chars().allMatch(digit -> digit == '0');
        boolean isTimed = !stamp.equals(Instant.EPOCH);
        List<ServedGoal> asked = goals.entrySet().stream()
                .filter(each -> (isOne && each.getKey().equals(id))
                        || (isTimed && !each.getValue().stamp().isAfter(stamp))
                        || (!isOne && !isTimed))
                .map(Map.Entry::getValue)
                .filter(goal -> !goal.ended())
                .toList();
        CdrWriter response = new CdrWriter()
                .int8((byte) (asked.isEmpty() ? returnCode(isOne, id) : 0))
                .int32(asked.size());
        for (ServedGoal goal : asked) {
            RosMessages.write(response.int8s(goal.id), goal.stamp());
            goal.status = Status.CANCELING;
        }
        publish();
        asked.forEach(handler::cancel);
        return CompletableFuture.completedStage(response.toBytes());
    }

    /// Of `action_msgs/CancelGoal`: rejected, unknown, or ended before.
    private int returnCode(boolean isOne, String id) {
        return !isOne ? 1 : goals.containsKey(id) ? 3 : 2;
    }

    /// The statuses of all goals.
    private void publish() {
        CdrWriter writer = new CdrWriter().int32(goals.size());
        for (ServedGoal goal : goals.values()) {
            RosMessages.write(writer.int8s(goal.id), goal.stamp()).int8(goal.status.code);
        }
        statuses.publish(writer.toBytes());
    }

    /// Of those that have ended: clients ask for a result before there is one.
    private void forgetOldest() {
        goals.values().stream().filter(ServedGoal::ended).findFirst().ifPresent(goals.values()::remove);
    }

    private void forget() {
        Instant now = time.ofRun();
        if (goals.values().removeIf(goal -> goal.forgotten.isBefore(now))) {
            publish();
        }
    }

    /// Ends those that are under way.
    public void abortAll() {
        goals.values().stream().filter(goal -> !goal.ended()).toList().forEach(goal -> {
            handler.cancel(goal);
            goal.end(Status.ABORTED, handler::writeNoResult);
        });
    }

    public void close() {
        abortAll();
        ends.forEach(Runnable::run);
    }
}
