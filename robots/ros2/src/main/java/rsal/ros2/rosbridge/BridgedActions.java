package rsal.ros2.rosbridge;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.time.Duration;
import java.util.HashMap;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.BooleanSupplier;
import java.util.function.Consumer;
import java.util.function.Function;
import java.util.function.IntSupplier;
import java.util.function.Supplier;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.PeerText;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.link.RosLink.Subscribed;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.InvalidDefinition;
import rsal.time.Scheduler;

/// Actions through a server. In ROS 2, an action is three services and a topic in its namespace `_action`; a
/// server of rosbridge hides these, and has operations for goals instead. This joins the two, so that clients
/// of actions need not know by what they are connected. On the scheduler's thread.
///
/// A server does not say that a goal was accepted. One counts as accepted with its first feedback, with its
/// result, or when it was not refused in time.
final class BridgedActions {
    private static final String HIDDEN = "/_action/";
    private static final String FEEDBACK = HIDDEN + "feedback";
    private static final String FEEDBACK_MESSAGE = "_FeedbackMessage";
    private static final Duration REFUSAL = Duration.ofMillis(1_500); // servers look for the action for 1 s
    private static final Duration KEPT = Duration.ofSeconds(10); // a result
    private static final int MOST_GOALS = 1_000;
    private static final WireValue SUCCEEDED = new WireValue.Int(4); // of action_msgs/msg/GoalStatus
    private static final String PREFIX = "rsal:goal:"; // of ids, which go on with those of the goals

    private final RosbridgeSession session;
    private final Scheduler scheduler;
    private final Supplier<Optional<MessageValues>> values;
    private final Map<String, Goal> goals = new HashMap<>(); // under way, or with a result that nobody has asked for
    private final Map<String, String> lost = new HashMap<>(); // actions of goals that a server may still pursue, by id
    private final List<Hearing> hearings = new CopyOnWriteArrayList<>();

    BridgedActions(RosbridgeSession session, Scheduler scheduler, Supplier<Optional<MessageValues>> values) {
        this.session = session;
        this.scheduler = scheduler;
        this.values = values;
    }

    /// @param topic of its feedback
    private record Hearing(RosTopic topic, Consumer<ByteBuffer> listener) {}

    /// @param action its name
    /// @param type of the action
    private record Goal(
            String action, String type, CompletableFuture<WireValue> accepted, CompletableFuture<WireValue> result) {
        void accept(boolean isAccepted) {
            accepted.complete(fields(Map.of("accepted", new WireValue.Bool(isAccepted))));
        }

        void fail(String why) {
            accepted.completeExceptionally(new IOException(why)); // where it is not accepted yet
            result.completeExceptionally(new IOException(why));
        }
    }

    private static WireValue.Fields fields(Map<String, WireValue> fields) {
        return new WireValue.Fields(fields);
    }

    /// The topic of an action's feedback.
    static RosTopic feedback(String name, String type) {
        return new RosTopic(name + FEEDBACK, type + FEEDBACK_MESSAGE);
    }

    /// The action that a service or a topic is a part of; empty when it is none.
    ///
    /// @param name of the service or the topic
    static Optional<String> action(String name) {
        int end = name.indexOf(HIDDEN);
        return end < 0 ? Optional.empty() : Optional.of(name.substring(0, end));
    }

    Subscribed subscribe(RosTopic topic, Consumer<ByteBuffer> listener, IntSupplier publishers) {
        var hearing = new Hearing(topic, listener);
        hearings.add(hearing);
        return new Subscribed() {
            @Override
            public int publishers() {
                return publishers.getAsInt();
            }

            @Override
            public void close() {
                hearings.remove(hearing);
            }
        };
    }

    /// @param name of the service, a part of an action
    ServiceClient client(String name, String type, BooleanSupplier isAvailable) {
        String action = action(name).orElseThrow();
        return switch (name.substring(name.lastIndexOf('/') + 1)) {
            case "send_goal" -> part(isAvailable, request -> send(action, type, request));
            case "get_result" -> part(isAvailable, request -> result(type, request));
            default -> part(isAvailable, request -> cancel(action, type, request));
        };
    }

    private static ServiceClient part(
            BooleanSupplier isAvailable, Function<byte[], CompletionStage<byte[]>> answering) {
        return new ServiceClient() {
            @Override
            public boolean isAvailable() {
                return isAvailable.getAsBoolean();
            }

            @Override
            public CompletionStage<byte[]> call(byte[] request) {
                try {
                    return answering.apply(request);
                } catch (InvalidDefinition e) { // the server's distribution does not have the action
                    return CompletableFuture.failedStage(new IOException(e.getMessage(), e));
                }
            }

            @Override
            public void close() {
                // servers keep nothing of clients
            }
        };
    }

    private CompletionStage<byte[]> failed(String why) {
        return CompletableFuture.failedStage(new IOException(session.trouble().orElse(why)));
    }

    private static String id(RosMessage goalId) {
        return PREFIX + HexFormat.of().formatHex(goalId.get("uuid", byte[].class));
    }

    /// @param type of the service: `nav2_msgs/action/NavigateToPose_SendGoal`
    private CompletionStage<byte[]> send(String action, String type, byte[] request) {
        Optional<MessageValues> known = values.get();
        if (known.isEmpty() || !session.isConnected() || goals.size() >= MOST_GOALS) {
            return failed("Too many goals are under way.");
        }
        MessageValues its = known.get();
        RosMessage message = its.ofCdr(type + "_Request", request);
        String id = id(message.message("goal_id"));
        String actionType = type.substring(0, type.lastIndexOf('_'));
        var goal = new Goal(action, actionType, new CompletableFuture<>(), new CompletableFuture<>());
        goals.put(id, goal);
        session.send("send_action_goal", out -> {
            out.writeStringProperty("id", id);
            out.writeStringProperty("action", action);
            out.writeStringProperty("action_type", actionType);
            out.writeName("args");
            its.write(message.message("goal"), out);
            out.writeBooleanProperty("feedback", true);
        });
        scheduler.after(REFUSAL, () -> goal.accept(true));
        return ResponseMessages.toCdr(goal.accepted, its, type + "_Response");
    }

    private CompletionStage<byte[]> result(String type, byte[] request) {
        Optional<MessageValues> known = values.get();
        if (known.isEmpty()) {
            return failed("Nobody knows such a goal.");
        }
        MessageValues its = known.get();
        String id = id(its.ofCdr(type + "_Request", request).message("goal_id"));
        Goal goal = goals.get(id);
        if (goal == null) {
            return failed("Nobody knows such a goal.");
        }
        var _ = goal.result.whenComplete((_, _) -> goals.remove(id, goal));
        return ResponseMessages.toCdr(goal.result, its, type + "_Response");
    }

    private CompletionStage<byte[]> cancel(String action, String type, byte[] request) {
        values.get().ifPresent(its -> {
            RosMessage goal = its.ofCdr(type + "_Request", request).message("goal_info");
            cancel(id(goal.message("goal_id")), action);
        });
        return failed("rosbridge does not report whether a goal was canceled.");
    }

    private void cancel(String id, String action) {
        session.send("cancel_action_goal", out -> {
            out.writeStringProperty("id", id);
            out.writeStringProperty("action", action);
        });
    }

    /// @param message `action_feedback`
    void onFeedback(WireValue.Fields message) throws InvalidMessage {
        String id = message.text("id").orElse("");
        String action = message.text("action").orElse("");
        Goal goal = goals.get(id);
        if (goal == null) {
            return; // of one that was given up
        }
        goal.accept(true);
        RosTopic topic = feedback(action, goal.type);
        WireValue uuid = new WireValue.Numbers(
                NumberArray.UINT8, ByteBuffer.wrap(HexFormat.of().parseHex(id.substring(PREFIX.length()))));
        WireValue whole = fields(Map.of(
                "goal_id",
                fields(Map.of("uuid", uuid)),
                "feedback",
                message.find("values").orElseGet(() -> fields(Map.of()))));
        byte[] bytes = values.get().orElseThrow().toCdr(topic.type(), whole);
        for (Hearing each : hearings) {
            if (each.topic.equals(topic)) {
                each.listener.accept(ByteBuffer.wrap(bytes));
            }
        }
    }

    /// @param message `action_result`
    void onResult(WireValue.Fields message) {
        String id = message.text("id").orElse("");
        Goal goal = goals.get(id);
        if (goal == null) {
            return; // of one that was given up
        }
        scheduler.after(KEPT, () -> goals.remove(id, goal)); // where nobody asks for it
        WireValue its = message.find("values").orElseGet(() -> fields(Map.of()));
        if (its instanceof WireValue.Fields) {
            goal.accept(true);
            goal.result.complete(fields(Map.of("status", message.find("status").orElse(SUCCEEDED), "result", its)));
        } else if (its instanceof WireValue.Text(String why) && why.contains("rejected")) {
            goal.accept(false);
            goal.fail(PeerText.shown(why));
        } else {
            goal.fail(its instanceof WireValue.Text(String why) ? PeerText.shown(why) : its.words());
        }
    }

    /// The server can't send a goal at all.
    void onRefused(String id, String why) {
        Goal goal = goals.remove(id);
        if (goal != null) {
            goal.fail(why);
        }
    }

    /// The server goes on with goals whose client has gone, and nobody hears of them any more.
    void onDisconnected() {
        goals.forEach((id, goal) -> {
            if (!goal.result.isDone()) {
                lost.put(id, goal.action);
            }
        });
        List<Goal> all = List.copyOf(goals.values());
        goals.clear();
        all.forEach(goal -> goal.fail("The connection to rosbridge was lost."));
    }

    /// Calls off what was lost: the server knows the goals of all of its clients, and ignores what it does not know.
    void onConnected() {
        lost.forEach(this::cancel);
        lost.clear();
    }
}
