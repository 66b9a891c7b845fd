package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.BridgeContext;
import rsal.system.CommandTimeout;
import rsal.time.LockstepScheduler;

/// What `ros2 param` and `ros2 lifecycle` ask of a node, and Nav2's programs before they send goals.
class NodesTest {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);
    private static final String NODE = "/r1/bt_navigator";
    private static final List<String> NAMES = List.of("use_sim_time", "command_timeout");

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final LockstepScheduler run = new LockstepScheduler();
    private final CompletableFuture<RosMessage> event = new CompletableFuture<>();
    private ActiveNode node;

    @BeforeEach
    void open() {
        there.subscribe(
                new RosTopic("/parameter_events", "rcl_interfaces/msg/ParameterEvent"), Profile.DEFAULT, bytes -> {
                    var copy = new byte[bytes.remaining()];
                    bytes.get(copy);
                    event.complete(read("rcl_interfaces/msg/ParameterEvent", copy));
                });
        var timeout = new CommandTimeout(Optional.of(Duration.ofMillis(700)), () -> 0);
        var map = new OccupancyGrid(1, 1, 1, 0, 0, new byte[1]);
        var context = new BridgeContext(List.of(), map, Optional.empty(), List.of(), timeout);
        node = new ActiveNode(network.join(), "/r1", "bt_navigator", NodeParameters.of(context), run, run);
    }

    private static RosMessage read(String type, byte[] message) {
        try {
            return MessageCodec.of(TYPES.get(type), TYPES).read(CdrReader.of(message));
        } catch (InvalidCdr e) {
            throw new AssertionError(type, e);
        }
    }

    private CompletableFuture<byte[]> ask(String name, byte[] request) {
        CompletableFuture<byte[]> response =
                there.client(NODE + "/" + name, "any").call(request).toCompletableFuture();
        run.runPending();
        return response;
    }

    private static byte[] request(String type, Map<String, Object> values) {
        MessageCodec codec = MessageCodec.of(TYPES.get(type + "_Request"), TYPES);
        var fields = new HashMap<>(codec.zero().fields());
        fields.putAll(values);
        return codec.write(new RosMessage(codec.type(), fields));
    }

    private RosMessage call(String name, String type, Map<String, Object> values) {
        return read(type + "_Response", ask(name, request(type, values)).join());
    }

    private static List<?> names(RosMessage result) {
        return result.get("names", List.class);
    }

    private static RosMessage parameter(String name) {
        MessageCodec codec = MessageCodec.of(TYPES.get("rcl_interfaces/msg/Parameter"), TYPES);
        var fields = new HashMap<>(codec.zero().fields());
        fields.put("name", name);
        return new RosMessage(codec.type(), fields);
    }

    @Test
    void parametersAreListedAndRead() {
        RosMessage all = call("list_parameters", "rcl_interfaces/srv/ListParameters", Map.of());
        assertThat(names(all.message("result"))).isEqualTo(NAMES);
        RosMessage some = call(
                "list_parameters", "rcl_interfaces/srv/ListParameters", Map.of("prefixes", List.of("use_sim_time")));
        assertThat(names(some.message("result"))).isEqualTo(List.of("use_sim_time"));
        Map<String, Object> asked = Map.of("names", List.of("command_timeout", "use_sim_time", "other"));
        List<RosMessage> values = call("get_parameters", "rcl_interfaces/srv/GetParameters", asked)
                .messages("values");
        assertThat(values.get(0).number("double_value")).isEqualTo(0.7);
        assertThat(values.get(1).get("bool_value", Boolean.class)).isTrue();
        assertThat(values).extracting(value -> value.integer("type")).containsExactly(3L, 1L, 0L);
        assertThat(call("get_parameter_types", "rcl_interfaces/srv/GetParameterTypes", asked)
                        .get("types", byte[].class))
                .containsExactly(3, 1, 0);
        List<RosMessage> described = call("describe_parameters", "rcl_interfaces/srv/DescribeParameters", asked)
                .messages("descriptors");
        assertThat(described.getFirst().text("description"))
                .isEqualTo("After which robots stop when no command comes [s]; 0 for never.");
        assertThat(described.getFirst().get("read_only", Boolean.class)).isTrue();
    }

    @Test
    void parametersAreReadOnly() {
        Map<String, Object> wanted = Map.of("parameters", List.of(parameter("use_sim_time"), parameter("other")));
        List<RosMessage> results = call("set_parameters", "rcl_interfaces/srv/SetParameters", wanted)
                .messages("results");
        assertThat(results)
                .extracting(result -> result.text("reason"))
                .containsExactly(
                        "Parameter 'use_sim_time' is read-only.",
                        "There is no parameter 'other', but use_sim_time, command_timeout.");
        assertThat(results)
                .extracting(result -> result.get("successful", Boolean.class))
                .containsOnly(false);
        RosMessage atOnce = call("set_parameters_atomically", "rcl_interfaces/srv/SetParametersAtomically", wanted);
        assertThat(atOnce.message("result").get("successful", Boolean.class)).isFalse();
    }

    @Test
    void thoseWhoListenHearOfParameters() {
        assertThat(event.join().text("node")).isEqualTo(NODE);
        assertThat(event.join().messages("new_parameters"))
                .extracting(parameter -> parameter.text("name"))
                .containsExactlyElementsOf(NAMES);
    }

    @Test
    void itIsActiveAndStaysSo() {
        assertThat(network.nodes()).containsExactly(NODE);
        RosMessage state =
                call("get_state", "lifecycle_msgs/srv/GetState", Map.of()).message("current_state");
        assertThat(state.integer("id")).isEqualTo(3);
        assertThat(state.text("label")).isEqualTo("active");
        assertThat(call("change_state", "lifecycle_msgs/srv/ChangeState", Map.of())
                        .get("success", Boolean.class))
                .isFalse();
        assertThat(call("get_available_states", "lifecycle_msgs/srv/GetAvailableStates", Map.of())
                        .messages("available_states"))
                .hasSize(1);
        for (String name : List.of("get_available_transitions", "get_transition_graph")) {
            assertThat(call(name, "lifecycle_msgs/srv/GetAvailableTransitions", Map.of())
                            .messages("available_transitions"))
                    .isEmpty();
        }
        node.close();
        assertThat(network.nodes()).isEmpty();
    }

    /// Damaged requests harm nobody.
    @Test
    void malformedRequestsAreNotAnswered() {
        var random = new SplittableRandom(2);
        int rounds = Boolean.getBoolean("rsal.test.all") ? 170_000 : 3_000; // times 6 services
        byte[] valid = request("rcl_interfaces/srv/GetParameters", Map.of("names", NAMES));
        for (int i = 0; i < rounds; i++) {
            byte[] damaged = valid.clone();
            for (int k = random.nextInt(1, 5); k > 0; k--) {
                damaged[random.nextInt(damaged.length)] = (byte) random.nextInt();
            }
            for (String name : List.of(
                    "get_parameters",
                    "get_parameter_types",
                    "describe_parameters",
                    "list_parameters",
                    "set_parameters",
                    "set_parameters_atomically")) {
                var _ = ask(name, damaged);
            }
        }
        RosMessage all = call("list_parameters", "rcl_interfaces/srv/ListParameters", Map.of());
        assertThat(names(all.message("result"))).isEqualTo(NAMES);
    }
}
