package rsal.ros2.rosbridge;

import java.nio.ByteBuffer;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosLink.ServiceClient;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import tools.jackson.core.json.JsonReadFeature;
import tools.jackson.databind.JsonNode;
import tools.jackson.databind.ObjectMapper;
import tools.jackson.databind.json.JsonMapper;
import tools.jackson.databind.node.ArrayNode;
import tools.jackson.databind.node.JsonNodeFactory;
import tools.jackson.databind.node.ObjectNode;

/// A server of rosbridge for tests, with the node `rosapi` beside it, made after what the sources of
/// rosbridge_suite do. Its topics are those of a network in memory. Of one thread, or under one lock.
public final class FakeRosbridge {
    private static final ObjectMapper MAPPER = JsonMapper.builder()
            .enable(JsonReadFeature.ALLOW_NON_NUMERIC_NUMBERS)
            .build();
    private static final String ITSELF = "/rosbridge_websocket";
    private static final String ROBOTS = "/robots";
    private static final String ACTION = "/_action/";

    private final MemoryNetwork network;
    private final boolean isRos1;
    private final PythonMessages messages;
    private final List<Client> clients = new CopyOnWriteArrayList<>();
    private final Map<String, String> goalIds = new HashMap<>(); // of the network, by those of all clients
    private boolean hasRosapi = true;
    private String distribution = "jazzy";
    private final Set<String> refused = new HashSet<>();
    private boolean isDown;
    private int goals;
    private final Map<String, String> deliveries = new HashMap<>(); // by topic

    /// @param isRos1 a server of ROS 1; of ROS 2 Jazzy otherwise
    public FakeRosbridge(MemoryNetwork network, boolean isRos1) {
        this.network = network;
        this.isRos1 = isRos1;
        messages = new PythonMessages(TypeLibrary.of(Distribution.JAZZY), isRos1);
    }

    /// What it says of its distribution. Its types stay the same.
    void distribution(String distribution) {
        this.distribution = distribution;
    }

    /// The node `rosapi` is not there from now on.
    void withoutRosapi() {
        hasRosapi = false;
    }

    /// The node `rosapi` refuses these questions from now on, such as `node_details`, and no others.
    public void refuse(Set<String> questions) {
        refused.clear();
        refused.addAll(questions);
    }

    /// All connections end, and none is accepted until [#up].
    public void down() {
        isDown = true;
        List.copyOf(clients).forEach(client -> client.drop("it closed the connection (1001)"));
    }

    public void up() {
        isDown = false;
    }

    public boolean hasClients() {
        return !clients.isEmpty();
    }

    /// How the newest subscription of a topic is to be delivered: `throttle_rate` and `queue_length`.
    String delivery(String topic) {
        return deliveries.getOrDefault(topic, "not subscribed to");
    }

    /// Sends all clients whatever it is.
    void sendAll(String text) {
        List.copyOf(clients).forEach(client -> client.text.accept(text));
    }

    public void sendAll(byte[] bytes) {
        List.copyOf(clients).forEach(client -> client.binary.accept(bytes));
    }

    /// Connections to it in memory, which hand messages over at once.
    public RosbridgeTransport transport() {
        return new RosbridgeTransport() {
            @Override
            public CompletionStage<Connection> open(Receiver receiver) {
                if (isDown) {
                    return CompletableFuture.failedStage(new java.io.IOException("nobody listens there"));
                }
                Client client = connect(
                        receiver::onText,
                        bytes -> receiver.onBinary(ByteBuffer.wrap(bytes)),
                        why -> receiver.onClosed(why));
                return CompletableFuture.completedStage(new Connection() {
                    @Override
                    public void send(String key, String message) {
                        client.receive(message);
                    }

                    @Override
                    public void close() {
                        client.close();
                    }

                    @Override
                    public void abort() {
                        client.close();
                    }
                });
            }

            @Override
            public void close() {
                // nothing is open
            }
        };
    }

    Client connect(Consumer<String> text, Consumer<byte[]> binary, Consumer<String> onDrop) {
        var client = new Client(text, binary, onDrop);
        clients.add(client);
        return client;
    }

    /// What one client has.
    final class Client {
        private final Consumer<String> text;
        private final Consumer<byte[]> binary;
        private final Consumer<String> onDrop;
        private final RosLink link = network.join();
        private final Map<String, Publication> advertised = new LinkedHashMap<>(); // by topic
        private final Map<String, String> types = new HashMap<>(); // of advertised ones
        private final Map<String, Hearing> hearings = new LinkedHashMap<>(); // by topic
        private final Map<String, CompletableFuture<byte[]>> requests = new HashMap<>(); // to services of the client
        private final Map<String, RosLink.Served> served = new HashMap<>();
        private boolean isClosed;

        private Client(Consumer<String> text, Consumer<byte[]> binary, Consumer<String> onDrop) {
            this.text = text;
            this.binary = binary;
            this.onDrop = onDrop;
        }

        private final class Hearing {
            private final TreeSet<String> ids = new TreeSet<>();
            private final String type;
            private String compression = "none";
            private RosLink.Subscribed subscribed = null;

            Hearing(String type) {
                this.type = type;
            }

            private void deliver(String topic, ByteBuffer bytes) {
                var copy = new byte[bytes.remaining()];
                bytes.duplicate().get(copy);
                RosMessage message = messages.ofCdr(type, copy);
                if (compression.equals("cbor")) {
                    try {
                        binary.accept(CborWriter.write(
                                Map.of("op", "publish", "topic", topic, "msg", messages.toCbor(message))));
                    } catch (PythonMessages.Refused e) {
                        return; // servers log it, and send nothing
                    }
                } else {
                    ObjectNode out = operation("publish").put("topic", topic);
                    out.set("msg", messages.toJson(message));
                    send(out);
                }
            }
        }

        void drop(String why) {
            close();
            onDrop.accept(why);
        }

        void close() {
            isClosed = true;
            clients.remove(this);
            link.close();
        }

        private void send(JsonNode node) {
            if (!isClosed) {
                text.accept(MAPPER.writeValueAsString(node));
            }
        }

        private void status(String message, JsonNode of) {
            ObjectNode out = operation("status").put("level", "error").put("msg", message);
            if (of.has("id")) {
                out.set("id", of.get("id"));
            }
            send(out);
        }

        void receive(String message) {
            JsonNode in = MAPPER.readTree(message);
            String operation = in.path("op").asString("");
            try {
                switch (operation) {
                    case "advertise" -> advertise(in);
                    case "unadvertise" -> {
                        Publication old = advertised.remove(in.get("topic").asString());
                        if (old != null) {
                            old.close();
                        }
                    }
                    case "publish" -> publish(in);
                    case "subscribe" -> subscribe(in);
                    case "unsubscribe" -> unsubscribe(in);
                    case "call_service" -> call(in);
                    case "advertise_service" -> serve(in);
                    case "unadvertise_service" ->
                        served.remove(in.get("service").asString()).close();
                    case "service_response" -> respond(in);
                    case "send_action_goal" -> sendGoal(in);
                    case "cancel_action_goal" -> cancelGoal(in);
                    default -> status("Unknown operation: " + operation, in);
                }
            } catch (PythonMessages.Refused e) {
                status(operation + ": " + e.getMessage(), in);
            }
        }

        private void advertise(JsonNode in) {
            String topic = in.get("topic").asString();
            String type = full(in.get("type").asString(), "msg");
            types.put(topic, type);
            Profile profile = in.path("latch").booleanValue(false) ? Profile.LATCHED : Profile.DEFAULT;
            advertised.computeIfAbsent(topic, _ -> link.advertise(new RosTopic(topic, type), profile));
        }

        private void publish(JsonNode in) throws PythonMessages.Refused {
            String topic = in.get("topic").asString();
            if (!advertised.containsKey(topic)) {
                throw new PythonMessages.Refused("Topic %s is not advertised".formatted(topic));
            }
            RosMessage message = messages.ofJson(types.get(topic), in.get("msg"));
            advertised.get(topic).publish(messages.toCdr(message));
        }

        private void subscribe(JsonNode in) throws PythonMessages.Refused {
            String topic = in.get("topic").asString();
            String type = full(in.get("type").asString(), "msg");
            for (RosEndpoint each : link.endpoints()) {
                if (each.topic().name().equals(topic) && !each.topic().type().equals(type)) {
                    throw new PythonMessages.Refused("Topic %s has the type %s, not %s"
                            .formatted(topic, each.topic().type(), type));
                }
            }
            deliveries.put(
                    topic,
                    "%d %d"
                            .formatted(
                                    in.path("throttle_rate").asInt(0),
                                    in.path("queue_length").asInt(0)));
            boolean isNew = !hearings.containsKey(topic);
            Hearing hearing = hearings.computeIfAbsent(topic, _ -> new Hearing(type));
            hearing.ids.add(in.get("id").asString());
            if (in.path("compression").asString("none").equals("cbor")) {
                hearing.compression = "cbor";
            }
            boolean isLatched = link.endpoints().stream()
                    .anyMatch(each -> each.isPublisher()
                            && each.topic().name().equals(topic)
                            && each.profile() == Profile.LATCHED);
            var subscribed = link.subscribe(
                    new RosTopic(topic, type),
                    isLatched ? Profile.LATCHED : Profile.SENSOR_DATA,
                    bytes -> hearing.deliver(topic, bytes));
            if (isNew) {
                hearing.subscribed = subscribed;
            } else {
                subscribed.close(); // it was there for what is latched
            }
        }

        private void unsubscribe(JsonNode in) {
            Hearing hearing = hearings.get(in.get("topic").asString());
            if (hearing != null && hearing.ids.remove(in.get("id").asString()) && hearing.ids.isEmpty()) {
                hearing.subscribed.close();
                hearings.remove(in.get("topic").asString());
            }
        }

        private void call(JsonNode in) throws PythonMessages.Refused {
            String service = in.get("service").asString();
            if (service.startsWith("/rosapi/") && hasRosapi) {
                Optional<ObjectNode> answer = rosapi(service.substring(8), in.path("args"));
                respond(
                        in,
                        answer.isPresent(),
                        answer.<JsonNode>map(each -> each)
                                .orElseGet(() -> text("Service %s does not exist".formatted(service))));
                return;
            }
            String type = network.serviceTypes().get(service);
            if (type == null) {
                respond(in, false, text("Service %s does not exist".formatted(service)));
                return;
            }
            RosMessage request;
            try {
                request = messages.ofJson(type + "_Request", in.path("args"));
            } catch (PythonMessages.Refused e) {
                respond(in, false, text(e.getMessage()));
                return;
            }
            link.client(service, type).call(messages.toCdr(request)).whenComplete((bytes, error) -> {
                if (error == null) {
                    respond(in, true, messages.toJson(messages.ofCdr(type + "_Response", bytes)));
                } else {
                    respond(in, false, text(String.valueOf(error.getMessage())));
                }
            });
        }

        private void respond(JsonNode to, boolean isGood, JsonNode values) {
            ObjectNode out = operation("service_response")
                    .put("service", to.get("service").asString())
                    .put("result", isGood);
            out.set("values", values);
            out.set("id", to.get("id"));
            send(out);
        }

        private void serve(JsonNode in) {
            String service = in.get("service").asString();
            String type = full(in.get("type").asString(), "srv");
            served.put(service, link.serve(service, type, request -> {
                String id = "service_request:%s:%d".formatted(service, requests.size());
                var answer = new CompletableFuture<byte[]>();
                requests.put(id, answer);
                ObjectNode out =
                        operation("call_service").put("service", service).put("id", id);
                out.set("args", messages.toJson(messages.ofCdr(type + "_Request", request)));
                send(out);
                return answer;
            }));
        }

        private void respond(JsonNode in) throws PythonMessages.Refused {
            CompletableFuture<byte[]> request = requests.get(in.get("id").asString());
            String type = network.serviceTypes().get(in.get("service").asString());
            if (in.get("result").booleanValue()) {
                request.complete(messages.toCdr(messages.ofJson(type + "_Response", in.get("values"))));
            } else {
                request.completeExceptionally(
                        new IllegalStateException(in.get("values").asString()));
            }
        }

        private void sendGoal(JsonNode in) {
            if (isRos1) {
                status("Unknown operation: send_action_goal", in);
                return;
            }
            String action = in.get("action").asString();
            String type = in.get("action_type").asString();
            String id = in.get("id").asString();
            if (!network.serviceTypes().containsKey(action + ACTION + "send_goal")) {
                result(in, false, 0, text("No action server available"));
                return;
            }
            RosMessage goal;
            try {
                goal = messages.ofJson(type + "_Goal", in.get("args"));
            } catch (PythonMessages.Refused e) {
                result(in, false, 0, text(e.getMessage()));
                return;
            }
            String uuid = "%032x".formatted(++goals);
            goalIds.put(id, uuid);
            if (in.path("feedback").booleanValue(false)) {
                hearFeedback(in, action, type, uuid);
            }
            ServiceClient sending = link.client(action + ACTION + "send_goal", type + "_SendGoal");
            RosMessage request = withId(type + "_SendGoal_Request", uuid).with("goal", goal);
            sending.call(messages.toCdr(request)).thenAccept(answer -> {
                if (messages.ofCdr(type + "_SendGoal_Response", answer).get("accepted", Boolean.class)) {
                    awaitResult(in, action, type, uuid);
                } else {
                    result(in, false, 0, text("Action goal was rejected"));
                }
            });
        }

        private RosMessage withId(String type, String uuid) {
            var library = TypeLibrary.of(Distribution.JAZZY);
            RosMessage message =
                    rsal.ros2.cdr.MessageCodec.of(library.get(type), library).zero();
            return message.with(
                    "goal_id",
                    message.message("goal_id")
                            .with("uuid", java.util.HexFormat.of().parseHex(uuid)));
        }

        private void hearFeedback(JsonNode in, String action, String type, String uuid) {
            var topic = new RosTopic(action + ACTION + "feedback", type + "_FeedbackMessage");
            link.subscribe(topic, Profile.DEFAULT, bytes -> {
                var copy = new byte[bytes.remaining()];
                bytes.duplicate().get(copy);
                RosMessage message = messages.ofCdr(topic.type(), copy);
                byte[] of = message.message("goal_id").get("uuid", byte[].class);
                if (java.util.HexFormat.of().formatHex(of).equals(uuid)) {
                    ObjectNode out = operation("action_feedback").put("action", action);
                    out.set("id", in.get("id"));
                    out.set("values", messages.toJson(message.message("feedback")));
                    send(out);
                }
            });
        }

        private void awaitResult(JsonNode in, String action, String type, String uuid) {
            byte[] request = messages.toCdr(withId(type + "_GetResult_Request", uuid));
            link.client(action + ACTION + "get_result", type + "_GetResult")
                    .call(request)
                    .thenAccept(answer -> {
                        RosMessage response = messages.ofCdr(type + "_GetResult_Response", answer);
                        result(in, true, response.integer("status"), messages.toJson(response.message("result")));
                    });
        }

        private void result(JsonNode to, boolean isGood, long status, JsonNode values) {
            ObjectNode out = operation("action_result")
                    .put("action", to.get("action").asString())
                    .put("status", status)
                    .put("result", isGood);
            out.set("values", values);
            out.set("id", to.get("id"));
            send(out);
        }

        private void cancelGoal(JsonNode in) {
            String uuid = goalIds.get(in.get("id").asString());
            if (uuid != null) {
                var library = TypeLibrary.of(Distribution.JAZZY);
                RosMessage request = rsal.ros2.cdr.MessageCodec.of(
                                library.get("action_msgs/srv/CancelGoal_Request"), library)
                        .zero();
                RosMessage info = request.message("goal_info");
                info = info.with(
                        "goal_id",
                        info.message("goal_id")
                                .with("uuid", java.util.HexFormat.of().parseHex(uuid)));
                var _ = link.client(in.get("action").asString() + ACTION + "cancel_goal", "action_msgs/srv/CancelGoal")
                        .call(messages.toCdr(request.with("goal_info", info)));
            }
        }

        private Optional<ObjectNode> rosapi(String question, JsonNode args) {
            if (refused.contains(question)) {
                return Optional.empty();
            }
            ObjectNode answer = JsonNodeFactory.instance.objectNode();
            List<RosEndpoint> others = link.endpoints();
            switch (question) {
                case "topics" -> {
                    ArrayNode names = answer.putArray("topics");
                    ArrayNode itsTypes = answer.putArray("types");
                    Map<String, String> all = new LinkedHashMap<>(Map.of("/rosout", "rcl_interfaces/msg/Log"));
                    others.forEach(
                            each -> all.put(each.topic().name(), each.topic().type()));
                    all.forEach((name, type) -> {
                        if (!name.contains(ACTION)) {
                            names.add(name);
                            itsTypes.add(isRos1 ? type.replace("/msg/", "/") : type);
                        }
                    });
                }
                case "nodes" ->
                    answer.putArray("nodes").add(ITSELF).add("/rosapi").add(ROBOTS);
                case "node_details" -> {
                    boolean isItself = args.path("node").asString().equals(ITSELF);
                    boolean isRobots = args.path("node").asString().equals(ROBOTS);
                    Stream<String> publishing = isItself ? advertised.keySet().stream() : Stream.of();
                    Stream<String> subscribing = isItself ? hearings.keySet().stream() : Stream.of();
                    if (isRobots) {
                        publishing = others.stream()
                                .filter(RosEndpoint::isPublisher)
                                .map(each -> each.topic().name());
                        subscribing = others.stream()
                                .filter(each -> !each.isPublisher())
                                .map(each -> each.topic().name());
                    }
                    ArrayNode publishes = answer.putArray("publishing");
                    publishing.filter(name -> !name.contains(ACTION)).forEach(publishes::add);
                    ArrayNode subscribes = answer.putArray("subscribing");
                    subscribing.filter(name -> !name.contains(ACTION)).forEach(subscribes::add);
                    ArrayNode services = answer.putArray("services");
                    if (isRobots) {
                        network.serviceTypes().keySet().forEach(services::add);
                    }
                }
                case "action_servers" -> {
                    ArrayNode actions = answer.putArray("action_servers");
                    others.stream()
                            .map(each -> each.topic().name())
                            .filter(name -> name.endsWith(ACTION + "feedback"))
                            .distinct()
                            .forEach(name -> actions.add(name.substring(0, name.indexOf(ACTION))));
                }
                case "action_type" -> {
                    String topic = args.path("action").asString() + ACTION + "feedback";
                    answer.put("type", "");
                    others.stream()
                            .map(RosEndpoint::topic)
                            .filter(each -> each.name().equals(topic))
                            .findFirst()
                            .ifPresent(each -> answer.put("type", each.type().replace("_FeedbackMessage", "")));
                }
                case "get_ros_version" -> {
                    if (isRos1) {
                        return Optional.empty();
                    }
                    answer.put("version", 2).put("distro", distribution);
                }
                default -> {
                    return Optional.empty();
                }
            }
            return Optional.of(answer);
        }
    }

    private static JsonNode text(String text) {
        return JsonNodeFactory.instance.stringNode(text);
    }

    private static ObjectNode operation(String operation) {
        return JsonNodeFactory.instance.objectNode().put("op", operation);
    }

    private String full(String type, String kind) {
        return isRos1 ? type.replaceFirst("/", "/%s/".formatted(kind)) : type;
    }
}
