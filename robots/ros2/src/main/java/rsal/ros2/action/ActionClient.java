package rsal.ros2.action;

import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.Map;
import java.util.Optional;
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
public final class ActionClient {
    public static final int SUCCEEDED = 4; // states of action_msgs/GoalStatus
    public static final int CANCELED = 5;
    public static final int ABORTED = 6;

    private static final int FEEDBACK_WAITING = 10;
    private static final int ID = 16; // bytes
    private static final Duration ANSWER = Duration.ofSeconds(5); // to a goal: yes or no; in real time
    private static final Duration SILENCE = Duration.ofSeconds(10); // of one that tells how goals get on

    private final String name;
    private final ServiceClient sending;
    private final ServiceClient results;
    private final ServiceClient canceling;
    private final Subscribed feedback;
    private final MessageCodec accepted;
    private final MessageCodec ended;
    private final Scheduler scheduler;
    private final RandomGenerator random;
    private final Map<String, Pursuit> pursuits = new HashMap<>(); // goals under way, by their ids

    /// A goal under way, as it is known here.
    private static final class Pursuit {
        private final Listener listener;
        private final Instant sent; // in real time, as programs answer in it even while a simulator is slow
        private boolean isAccepted;
        private boolean hasFeedback;
        private Instant heard; // the newest of it, or when it was sent

        Pursuit(Listener listener, Instant sent, Instant heard) {
            this.listener = listener;
            this.sent = sent;
            this.heard = heard;
        }

        /// Why it is lost; empty as long as it is not. Servers need not tell how a goal gets on.
        ///
        /// @param real now in real time
        Optional<String> loss(Instant now, Instant real) {
            Duration silence = Duration.between(heard, now);
            if (!isAccepted && Duration.between(sent, real).compareTo(ANSWER) > 0) {
                return Optional.of("The robot did not answer within %d s.".formatted(ANSWER.toSeconds()));
            }
            return hasFeedback && listener.tellsSteadily() && silence.compareTo(SILENCE) > 0
                    ? Optional.of(
                            "The robot has reported nothing about the goal for %d s.".formatted(SILENCE.toSeconds()))
                    : Optional.empty();
        }
    }

    /// What comes of a goal. Its ending comes once: that it is refused, its result, or that it failed.
    public interface Listener {
        /// @param message the feedback of the action's type
        void onFeedback(RosMessage message);

        /// Whether feedback comes steadily while the goal is pursued, so that silence means that it is lost.
        default boolean tellsSteadily() {
            return true;
        }

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
    public record Goal(String id) {
        byte[] bytes() {
            return HexFormat.of().parseHex(id);
        }
    }

    /// @param name with its namespace: `/robot1/navigate_to_pose`
    /// @param type `nav2_msgs/action/NavigateToPose`
    /// @param random for ids of goals, which nobody else may have
    public ActionClient(
            RosLink link, TypeLibrary types, String name, String type, Scheduler scheduler, RandomGenerator random) {
        this.name = name;
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

    /// With its namespace.
    public String name() {
        return name;
    }

    /// Whether somebody serves the action.
    public boolean isAvailable() {
        return sending.isAvailable() && results.isAvailable();
    }

    /// @param goal writes the fields of the goal
    public Goal send(Consumer<CdrWriter> goal, Listener listener) {
        var id = new byte[ID];
        random.nextBytes(id);
        var sent = new Goal(HexFormat.of().formatHex(id));
        var pursuit = new Pursuit(listener, scheduler.inRealTime().instant(), scheduler.instant());
        pursuits.put(sent.id, pursuit); // feedback may come before the response
        CdrWriter request = new CdrWriter().int8s(id);
        goal.accept(request);
        answer(sending.call(request.toBytes()), accepted, sent, response -> {
            pursuit.isAccepted = response.get("accepted", Boolean.class);
            pursuit.heard = scheduler.instant();
            if (pursuit.isAccepted && !pursuits.containsKey(sent.id)) {
                cancel(sent); // as it was called off before the server had it
            } else if (pursuit.isAccepted) {
                answer(
                        results.call(new CdrWriter().int8s(id).toBytes()),
                        ended,
                        sent,
                        result -> finish(sent, last -> last.onResult(result)));
            } else {
                finish(sent, Listener::onRefused);
            }
        });
        return sent;
    }

    /// The first ending counts.
    private void finish(Goal goal, Consumer<Listener> ending) {
        Pursuit last = pursuits.remove(goal.id);
        if (last != null) {
            ending.accept(last.listener);
        }
    }

    /// Ends goals of which nothing is heard any more.
    public void look(Instant now) {
        Instant real = scheduler.inRealTime().instant();
        Map.copyOf(pursuits)
                .forEach((id, pursuit) ->
                        pursuit.loss(now, real).ifPresent(why -> finish(new Goal(id), lost -> lost.onFailure(why))));
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
        finish(goal, lost -> lost.onFailure(why));
    }

    private void onFeedback(RosMessage message) {
        byte[] id = message.message("goal_id").get("uuid", byte[].class);
        Pursuit pursuit = pursuits.get(HexFormat.of().formatHex(Arrays.copyOf(id, ID)));
        if (pursuit != null) {
            pursuit.hasFeedback = true;
            pursuit.heard = scheduler.instant();
            pursuit.listener.onFeedback(message.message("feedback"));
        }
    }

    /// Asks to give it up. Nothing more is heard of it.
    public void cancel(Goal goal) {
        pursuits.remove(goal.id);
        var _ = canceling.call(
                new CdrWriter().int8s(goal.bytes()).int32(0).int32(0).toBytes());
    }

    public void close() {
        pursuits.clear();
        sending.close();
        results.close();
        canceling.close();
        feedback.close();
    }
}
