package rsal.ros2.device;

import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.random.RandomGenerator;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Inbox;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;

/// Has somebody pursue goals: a client of an action of ROS 2. All on the scheduler's thread.
final class ActionClient {
    private static final int FEEDBACK_WAITING = 10;
    private static final int ID = 16; // bytes

    private final ServiceClient sending;
    private final ServiceClient results;
    private final ServiceClient canceling;
    private final Subscribed feedback;
    private final MessageCodec accepted;
    private final MessageCodec ended;
    private final Scheduler scheduler;
    private final RandomGenerator random;
    private final Map<String, Listener> listeners = new HashMap<>(); // of goals under way, by their ids

    /// What comes of a goal. Its ending comes once: that it is refused, its result, or that it failed.
    interface Listener {
        /// @param message the feedback of the action's type
        void onFeedback(RosMessage message);

        /// Nobody pursues it.
        void onRefused();

        /// @param response `GetResult_Response` of the action's type: with a status and a result
        void onResult(RosMessage response);

        /// What it does can't be known any more.
        void onFailure(String why);
    }

    /// A goal under way.
    ///
    /// @param id unique
    record Goal(String id) {
        byte[] bytes() {
            return HexFormat.of().parseHex(id);
        }
    }

    /// @param name with its namespace: `/robot1/navigate_to_pose`
    /// @param type `nav2_msgs/action/NavigateToPose`
    /// @param random for ids of goals, which nobody else may have
    ActionClient(
            RosLink link, TypeLibrary types, String name, String type, Scheduler scheduler, RandomGenerator random) {
        this.scheduler = scheduler;
        this.random = random;
        sending = link.client(name + "/_action/send_goal", type + "_SendGoal");
        results = link.client(name + "/_action/get_result", type + "_GetResult");
        canceling = link.client(name + "/_action/cancel_goal", "action_msgs/srv/CancelGoal");
        accepted = codec(types, type + "_SendGoal_Response");
        ended = codec(types, type + "_GetResult_Response");
        var inbox = new Inbox<>(
                FEEDBACK_WAITING, codec(types, type + "_FeedbackMessage")::read, scheduler, this::onFeedback);
        feedback = link.subscribe(
                new RosTopic(name + "/_action/feedback", type + "_FeedbackMessage"), Profile.DEFAULT, inbox);
    }

    private static MessageCodec codec(TypeLibrary types, String type) {
        return MessageCodec.of(types.get(type), types);
    }

    /// Whether somebody serves the action.
    boolean isAvailable() {
        return sending.isAvailable() && results.isAvailable();
    }

    /// @param goal writes the fields of the goal
    Goal send(Consumer<CdrWriter> goal, Listener listener) {
        var id = new byte[ID];
        random.nextBytes(id);
        var sent = new Goal(HexFormat.of().formatHex(id));
        listeners.put(sent.id, listener); // feedback may come before the response
        CdrWriter request = new CdrWriter().int8s(id);
        goal.accept(request);
        answer(sending.call(request.toBytes()), accepted, sent, response -> {
            boolean isAccepted = response.get("accepted", Boolean.class);
            if (isAccepted && !listeners.containsKey(sent.id)) {
                cancel(sent); // as it was called off before the server had it
            } else if (isAccepted) {
                answer(results.call(new CdrWriter().int8s(id).toBytes()), ended, sent, result -> {
                    Listener last = listeners.remove(sent.id);
                    if (last != null) {
                        last.onResult(result);
                    }
                });
            } else {
                Listener refused = listeners.remove(sent.id);
                if (refused != null) {
                    refused.onRefused();
                }
            }
        });
        return sent;
    }

    private void answer(CompletionStage<byte[]> call, MessageCodec codec, Goal goal, Consumer<RosMessage> receiver) {
        call.whenCompleteAsync(
                (bytes, error) -> {
                    if (error != null) {
                        fail(goal, String.valueOf(error.getMessage()));
                        return;
                    }
                    try {
                        receiver.accept(codec.read(CdrReader.of(bytes)));
                    } catch (InvalidCdr e) {
                        fail(goal, String.valueOf(e.getMessage()));
                    }
                },
                scheduler);
    }

    private void fail(Goal goal, String why) {
        Listener listener = listeners.remove(goal.id);
        if (listener != null) {
            listener.onFailure(why);
        }
    }

    private void onFeedback(RosMessage message) {
        byte[] id = message.message("goal_id").get("uuid", byte[].class);
        Listener listener = listeners.get(HexFormat.of().formatHex(Arrays.copyOf(id, ID)));
        if (listener != null) {
            listener.onFeedback(message.message("feedback"));
        }
    }

    /// Asks to give it up. Nothing more is heard of it.
    void cancel(Goal goal) {
        listeners.remove(goal.id);
        var _ = canceling.call(
                new CdrWriter().int8s(goal.bytes()).int32(0).int32(0).toBytes());
    }

    void close() {
        listeners.clear();
        sending.close();
        results.close();
        canceling.close();
        feedback.close();
    }
}
