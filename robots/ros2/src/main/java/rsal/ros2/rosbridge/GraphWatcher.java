package rsal.ros2.rosbridge;

import java.io.IOException;
import java.lang.System.Logger;
import java.lang.System.Logger.Level;
import java.time.Duration;
import java.util.Arrays;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionException;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.Scheduler;
import rsal.time.Task;
import tools.jackson.core.JsonGenerator;

/// Asks a server's `rosapi` again and again who publishes, subscribes and serves: one question after the
/// other, so that slow robots can keep up. On the scheduler's thread; what it found may be read on any.
final class GraphWatcher {
    private static final Logger LOG = System.getLogger(GraphWatcher.class.getName());
    private static final Duration PAUSE = Duration.ofSeconds(1); // between two looks
    private static final Duration ANSWER = Duration.ofSeconds(5); // to a question
    private static final int MOST_NODES = 500;
    private static final int KEPT = 3; // rounds for which an older answer stands in for one that is refused
    private static final String BRIDGE = "rosbridge_websocket"; // the server's own node

    private final RosbridgeSession session;
    private final Scheduler scheduler;
    private final Optional<Distribution> wanted;
    private final Used used;
    private final Consumer<MessageValues> onKnown;
    private final Map<String, String> actionTypes = new HashMap<>(); // by name; empty where nobody knows it
    private final Map<String, Integer> untyped = new HashMap<>(); // how often that was refused, by name
    private final Map<String, Known> nodes = new HashMap<>(); // what they told last, by name
    private Known actionServers = Known.NONE;
    private Map<String, String> types = Map.of(); // of topics, as they were told last
    private Optional<Task> next = Optional.empty();
    private boolean isWatching;
    private int round; // of connections: answers to an old one's questions don't count
    private volatile Optional<Distribution> distribution = Optional.empty();
    private Optional<RosVersion> version = Optional.empty();
    private volatile Graph graph = Graph.EMPTY;
    private volatile boolean isComplete; // that graph, as the server has answered all questions
    private volatile List<RosEndpoint> endpoints = List.of();

    /// An answer, and for how many rounds it has stood in for newer ones: busy servers refuse some questions.
    private record Known(WireValue.Fields answer, int rounds) {
        static final Known NONE = new Known(new WireValue.Fields(Map.of()), KEPT);

        static Known fresh(WireValue.Fields answer) {
            return new Known(answer, 0);
        }

        Known older() {
            return rounds < KEPT ? new Known(answer, rounds + 1) : NONE;
        }
    }

    /// What this program uses through the server, whose node has it then.
    interface Used {
        boolean publishes(String topic);

        boolean subscribes(String topic);
    }

    /// @param wanted distribution of ROS 2; empty for what the server says
    /// @param onKnown hears once which messages the server has
    GraphWatcher(
            RosbridgeSession session,
            Scheduler scheduler,
            Optional<Distribution> wanted,
            Used used,
            Consumer<MessageValues> onKnown) {
        this.session = session;
        this.scheduler = scheduler;
        this.wanted = wanted;
        this.used = used;
        this.onKnown = onKnown;
    }

    Graph graph() {
        return graph;
    }

    List<RosEndpoint> endpoints() {
        return endpoints;
    }

    /// Whether the server has answered all questions since it was connected.
    boolean isComplete() {
        return isComplete;
    }

    /// Whose types the messages have; empty before the server has answered.
    Optional<Distribution> distribution() {
        return distribution;
    }

    void begin() {
        isWatching = true;
        round++;
        look(round);
    }

    void end() {
        isWatching = false;
        round++;
        next.ifPresent(Task::cancel);
        nodes.clear();
        actionServers = Known.NONE;
        isComplete = false;
        found(Graph.EMPTY);
    }

    private void found(Graph newest) {
        graph = newest;
        List<RosEndpoint> all = newest.endpoints();
        if (!all.equals(endpoints)) {
            endpoints = all;
        }
    }

    private void look(int of) {
        session.checkSilence();
        if (!isWatching || of != round) {
            return;
        }
        var draft = new Draft();
        ask("topics", _ -> {})
                .thenCompose(topics -> know(topics).thenCompose(_ -> ask("nodes", _ -> {})))
                .thenCompose(answer -> details(answer.texts("nodes"), draft))
                .thenCompose(_ -> actions(draft))
                .whenComplete((_, error) -> {
                    if (!isWatching || of != round) {
                        return;
                    }
                    if (error == null) {
                        session.noTrouble();
                        found(draft.toGraph());
                        isComplete = true;
                    } else {
                        fail(error);
                    }
                    next = Optional.of(scheduler.after(PAUSE, () -> look(of)));
                });
    }

    private void fail(Throwable error) {
        String why = String.valueOf(ResponseMessages.reason(error).getMessage()).replaceFirst("[.]$", "");
        String words =
                "rosbridge at '%s' does not report its topics (/rosapi/topics): %s. Does the node rosapi run beside it?"
                        .formatted(session.address(), why);
        if (session.trouble().isEmpty()) {
            LOG.log(Level.WARNING, words);
        }
        session.trouble(words);
    }

    private CompletionStage<WireValue.Fields> ask(String question, Consumer<JsonGenerator> fields) {
        return scheduler.within(ANSWER, session.call("/rosapi/" + question, out -> {
            out.writeStartObject();
            fields.accept(out);
            out.writeEndObject();
        }));
    }

    /// As [#ask], but empty when the server refuses: what was asked for may be gone, or a service not there.
    private CompletionStage<Optional<WireValue.Fields>> tryTo(String question, Consumer<JsonGenerator> fields) {
        return ask(question, fields).handle((answer, error) -> {
            if (error != null && !(ResponseMessages.reason(error) instanceof IOException)) {
                throw new CompletionException(ResponseMessages.reason(error)); // no answer at all
            }
            return Optional.ofNullable(answer);
        });
    }

    /// Learns which ROS the server bridges, once.
    private CompletionStage<Void> know(WireValue.Fields topics) {
        types = new HashMap<>();
        List<String> names = topics.texts("topics");
        List<String> itsTypes = topics.texts("types");
        for (int i = 0; i < Math.min(names.size(), itsTypes.size()); i++) {
            types.put(names.get(i), RosVersion.full(itsTypes.get(i)));
        }
        if (version.isPresent() || itsTypes.isEmpty()) {
            return CompletableFuture.completedStage(null);
        }
        RosVersion spoken = RosVersion.of(itsTypes);
        return tryTo("get_ros_version", _ -> {}).thenAccept(answer -> {
            String name = answer.flatMap(says -> says.text("distro")).orElse("");
            Distribution its = wanted.orElseGet(() -> named(name));
            version = Optional.of(spoken);
            distribution = Optional.of(its);
            onKnown.accept(new MessageValues(TypeLibrary.of(its), spoken));
        });
    }

    /// The distribution of that name; of others, as ROS 1, the usual one: fields go by their names.
    private static Distribution named(String name) {
        return Arrays.stream(Distribution.values())
                .filter(each -> each.words().equals(name))
                .findFirst()
                .orElse(Distribution.JAZZY);
    }

    private CompletionStage<Void> details(List<String> names, Draft draft) {
        List<String> all = names.subList(0, Math.min(names.size(), MOST_NODES));
        nodes.keySet().retainAll(Set.copyOf(all));
        return details(all, 0, draft);
    }

    private CompletionStage<Void> details(List<String> names, int i, Draft draft) {
        if (i >= names.size()) {
            return CompletableFuture.completedStage(null);
        }
        String node = names.get(i);
        return tryTo("node_details", out -> out.writeStringProperty("node", node))
                .thenCompose(answer -> {
                    Known its = answer.map(Known::fresh)
                            .orElseGet(
                                    () -> nodes.getOrDefault(node, Known.NONE).older());
                    nodes.put(node, its);
                    draft.add(node, its.answer);
                    return details(names, i + 1, draft);
                });
    }

    /// ROS 1 has none of this kind.
    private CompletionStage<Void> actions(Draft draft) {
        if (version.equals(Optional.of(RosVersion.ROS_1))) {
            return CompletableFuture.completedStage(null);
        }
        return tryTo("action_servers", _ -> {}).thenCompose(answer -> {
            actionServers = answer.map(Known::fresh).orElseGet(actionServers::older);
            List<String> names = actionServers.answer.texts("action_servers");
            actionTypes.keySet().retainAll(Set.copyOf(names));
            untyped.keySet().retainAll(Set.copyOf(names));
            return actionTypes(names, 0, draft);
        });
    }

    private CompletionStage<Void> actionTypes(List<String> names, int i, Draft draft) {
        if (i >= Math.min(names.size(), MOST_NODES)) {
            return CompletableFuture.completedStage(null);
        }
        String name = names.get(i);
        if (actionTypes.containsKey(name)) {
            draft.action(name, actionTypes.get(name));
            return actionTypes(names, i + 1, draft);
        }
        return tryTo("action_type", out -> out.writeStringProperty("action", name))
                .thenCompose(answer -> {
                    String type = answer.flatMap(its -> its.text("type"))
                            .filter(its -> !its.isEmpty())
                            .orElseGet(() -> guessed(name));
                    draft.action(name, type);
                    if (answer.isPresent() || untyped.merge(name, 1, Integer::sum) > KEPT) {
                        actionTypes.put(name, type);
                    }
                    return actionTypes(names, i + 1, draft);
                });
    }

    /// Older servers don't say which type an action has. Those of Nav2 are named after it: `navigate_to_pose`
    /// is a `NavigateToPose`. Empty where the server's distribution has no such type.
    private String guessed(String name) {
        String type = Arrays.stream(name.substring(name.lastIndexOf('/') + 1).split("_", -1))
                .filter(word -> !word.isEmpty())
                .map(word -> Character.toUpperCase(word.charAt(0)) + word.substring(1))
                .collect(Collectors.joining());
        String whole = "nav2_msgs/action/" + type;
        boolean isKnown = distribution
                .flatMap(its -> TypeLibrary.of(its).find(whole + "_Goal"))
                .isPresent();
        return isKnown ? whole : "";
    }

    /// What is found, as long as not all is.
    private final class Draft {
        private final Map<RosTopic, Integer> publishers = new LinkedHashMap<>();
        private final Set<RosTopic> subscribed = new HashSet<>();
        private final Set<String> services = new HashSet<>();
        private final Map<String, String> actions = new LinkedHashMap<>();

        void add(String node, WireValue.Fields its) {
            boolean isBridge = node.endsWith("/" + BRIDGE);
            for (String topic : its.texts("publishing")) {
                if (types.containsKey(topic) && !(isBridge && used.publishes(topic))) {
                    publishers.merge(new RosTopic(topic, types.get(topic)), 1, Integer::sum);
                }
            }
            for (String topic : its.texts("subscribing")) {
                if (types.containsKey(topic) && !(isBridge && used.subscribes(topic))) {
                    subscribed.add(new RosTopic(topic, types.get(topic)));
                }
            }
            services.addAll(its.texts("services"));
        }

        void action(String name, String type) {
            actions.put(name, type);
        }

        Graph toGraph() {
            return new Graph(publishers, subscribed, services, actions);
        }
    }
}
