package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.function.Consumer;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.SimulationControl;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.ClockTopics;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// The services of `simulation_interfaces`, as their requests and responses are defined.
class SimulationServerTest extends RobotBench {
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY); // with version 1 of the package
    private static final String SERVICES = "simulation_interfaces/srv/";
    private static final String ACTION = "simulation_interfaces/action/SimulateSteps";
    private static final Map<String, String> NAMES = names();

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private FakeRunControl control;
    private SimulationControl world;
    private final List<Long> times = new ArrayList<>(); // of /clock [ns]
    private Bridge bridge;

    private static Map<String, String> names() {
        var names = new LinkedHashMap<String, String>();
        List.of(
                        "GetSimulatorFeatures",
                        "GetEntities",
                        "GetEntitiesStates",
                        "GetEntityState",
                        "SetEntityState",
                        "GetEntityInfo",
                        "GetSpawnables",
                        "SpawnEntity",
                        "DeleteEntity",
                        "ResetSimulation",
                        "GetSimulationState",
                        "SetSimulationState",
                        "StepSimulation")
                .forEach(type -> names.put(
                        type, "/rsal/" + type.replaceAll("(?<!^)([A-Z])", "_$1").toLowerCase(java.util.Locale.ROOT)));
        return names;
    }

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @BeforeEach
    void publish() {
        world = system().simulation().orElseThrow();
        control = new FakeRunControl(world, run);
        control.spawn("puck", "b1", new Pose2d(6, 5, 0));
        bridge = PublishedRobots.publish(List.of(robot()), WORLD.grid(), world, control, network.join(), run);
        there.subscribe(ClockTopics.CLOCK, Profile.SENSOR_DATA, bytes -> {
            try {
                times.add(RosMessages.stamp(CdrReader.of(bytes)));
            } catch (InvalidCdr e) {
                throw new AssertionError(e);
            }
        });
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    /// A message with some fields set; those of messages within have names with dots.
    private static RosMessage message(MessageCodec codec, Map<String, Object> values) {
        return with(codec.zero(), values);
    }

    private static RosMessage with(RosMessage message, Map<String, Object> values) {
        var fields = new HashMap<>(message.fields());
        values.forEach((name, value) -> {
            int dot = name.indexOf('.');
            if (dot < 0) {
                fields.put(name, value);
            } else {
                String outer = name.substring(0, dot);
                fields.put(outer, with((RosMessage) fields.get(outer), Map.of(name.substring(dot + 1), value)));
            }
        });
        return new RosMessage(message.type(), fields);
    }

    private static byte[] request(String type, Map<String, Object> values) {
        MessageCodec codec = MessageCodec.of(TYPES.get(SERVICES + type + "_Request"), TYPES);
        return codec.write(message(codec, values));
    }

    private CompletableFuture<byte[]> ask(String name, byte[] request) {
        CompletableFuture<byte[]> response =
                there.client(name, "any").call(request).toCompletableFuture();
        run.runPending();
        return response;
    }

    private static RosMessage read(String type, byte[] response) {
        try {
            return MessageCodec.of(TYPES.get(type), TYPES).read(CdrReader.of(response));
        } catch (InvalidCdr e) {
            throw new AssertionError(type, e);
        }
    }

    private RosMessage call(String type, Map<String, Object> values) {
        CompletableFuture<byte[]> response = ask(NAMES.get(type), request(type, values));
        assertThat(response).as(type).isCompleted();
        return read(SERVICES + type + "_Response", response.join());
    }

    private static long code(RosMessage response) {
        return response.message("result").integer("result");
    }

    private static String why(RosMessage response) {
        return response.message("result").text("error_message");
    }

    private static List<?> names(RosMessage response) {
        return response.get("entities", List.class);
    }

    @Test
    void onlyWhatIsOfferedIsAFeature() {
        short[] features =
                call("GetSimulatorFeatures", Map.of()).message("features").get("features", short[].class);
        assertThat(features).containsExactly(0, 1, 8, 10, 11, 12, 14, 20, 21, 22, 23, 24, 25, 26, 31, 32, 33);
        control.pausable = false;
        features = call("GetSimulatorFeatures", Map.of()).message("features").get("features", short[].class);
        assertThat(features).contains((short) 0).doesNotContain((short) 26, (short) 31, (short) 33);
    }

    @Test
    void entitiesAreListedByNameAndCategory() {
        assertThat(names(call("GetEntities", Map.of()))).isEqualTo(List.of("r1", "b1"));
        assertThat(names(call("GetEntities", Map.of("filters.filter", "^b[0-9]+$"))))
                .isEqualTo(List.of("b1"));
        assertThat(names(call("GetEntities", Map.of("filters.filter", "1")))).isEqualTo(List.of("r1", "b1"));
        MessageCodec category = MessageCodec.of(TYPES.get("simulation_interfaces/msg/EntityCategory"), TYPES);
        List<RosMessage> robots = List.of(message(category, Map.of("category", 1L)));
        assertThat(names(call("GetEntities", Map.of("filters.categories", robots))))
                .isEqualTo(List.of("r1"));
    }

    @Test
    void filtersThatCantBeAreRefused() {
        RosMessage open = call("GetEntities", Map.of("filters.filter", "b["));
        assertThat(code(open)).isEqualTo(4);
        assertThat(why(open)).startsWith("The filter 'b[' is not a regular expression:");
        assertThat(code(call("GetEntities", Map.of("filters.tags.tags", List.of("big")))))
                .isZero();
        assertThat(code(call("GetEntities", Map.of("filters.bounds.type", 1L)))).isZero();
        assertThat(code(call("GetEntities", Map.of("filters.filter", "a".repeat(201)))))
                .isEqualTo(4);
        control.spawn("puck", "a".repeat(60), new Pose2d(7, 5, 0));
        RosMessage evil = call("GetEntities", Map.of("filters.filter", "^(a*)(a*)(a*)(a*)(a*)(a*)b"));
        assertThat(code(evil)).isEqualTo(4);
        assertThat(why(evil)).startsWith("The filter takes too long.");
        assertThat(names(evil)).isEmpty();
    }

    @Test
    void statesHavePosesAndVelocities() {
        drive(Twist2d.drive(0.3, 0), 2);
        RosMessage all = call("GetEntitiesStates", Map.of());
        assertThat(names(all)).isEqualTo(List.of("r1", "b1"));
        RosMessage robot = all.messages("states").getFirst();
        RosMessage one = call("GetEntityState", Map.of("entity", "r1"));
        assertThat(one.message("state")).isEqualTo(robot);
        Pose2d truth = world.truth("r1").orElseThrow();
        assertThat(robot.message("header").text("frame_id")).isEqualTo("map");
        assertThat(robot.message("pose").message("position").number("x")).isEqualTo(truth.x());
        assertThat(robot.message("twist").message("linear").number("x")).isCloseTo(0.3, within(0.02));
        assertThat(robot.message("twist").message("linear").number("y")).isCloseTo(0, within(0.02));
        assertThat(all.messages("states")
                        .getLast()
                        .message("pose")
                        .message("position")
                        .number("y"))
                .isEqualTo(5);
    }

    /// In the frame of the map, with velocities in the robot's own.
    @Test
    void theTruthIsPublished() {
        var heard = new ArrayList<RosMessage>();
        world.place("r1", new Pose2d(6, 4, Math.PI / 2));
        there.subscribe(new RosTopic("/r1/ground_truth", "nav_msgs/msg/Odometry"), Profile.DEFAULT, bytes -> {
            var copy = new byte[bytes.remaining()];
            bytes.get(copy);
            heard.add(read("nav_msgs/msg/Odometry", copy));
        });
        drive(Twist2d.drive(0.3, 0), 2);
        assertThat(heard).hasSizeBetween(39, 41);
        RosMessage last = heard.getLast();
        assertThat(last.message("header").text("frame_id")).isEqualTo("map");
        assertThat(last.text("child_frame_id")).isEqualTo("base_link");
        RosMessage position = last.message("pose").message("pose").message("position");
        assertThat(position.number("y")).isBetween(4.3, 4.7);
        RosMessage velocity = last.message("twist").message("twist").message("linear");
        assertThat(velocity.number("x")).isCloseTo(0.3, within(0.02));
        assertThat(velocity.number("y")).isCloseTo(0, within(0.02));
    }

    @Test
    void entitiesThatAreNotThereAreNotFound() {
        for (String type : List.of("GetEntityState", "GetEntityInfo", "SetEntityState", "DeleteEntity")) {
            RosMessage response = call(type, Map.of("entity", "r2"));
            assertThat(code(response)).as(type).isEqualTo(2);
            assertThat(why(response)).startsWith("There is no entity 'r2'.");
        }
    }

    @Test
    void infosSayWhatSomethingIs() {
        RosMessage robot = call("GetEntityInfo", Map.of("entity", "r1")).message("info");
        assertThat(robot.message("category").integer("category")).isEqualTo(1);
        assertThat(robot.text("description")).isEqualTo("A robot: Pioneer 2-DX, with the role 'tested'.");
        RosMessage thing = call("GetEntityInfo", Map.of("entity", "b1")).message("info");
        assertThat(thing.message("category").integer("category")).isZero();
        assertThat(thing.text("description")).isEqualTo("A thing.");
    }

    private static Map<String, Object> at(double x, double y) {
        return Map.of("entity", "r1", "state.pose.position.x", x, "state.pose.position.y", y);
    }

    @Test
    void entitiesArePlaced() {
        assertThat(code(call("SetEntityState", at(8, 3)))).isEqualTo(1);
        assertThat(world.truth("r1")).contains(new Pose2d(8, 3, 0));
        RosMessage inTheWall = call("SetEntityState", at(0, 0));
        assertThat(code(inTheWall)).isEqualTo(4);
        assertThat(why(inTheWall)).contains("'wall' is in the way");
        assertThat(code(call("SetEntityState", at(Double.NaN, 0)))).isEqualTo(101);
        var elsewhere = new HashMap<>(at(8, 3));
        elsewhere.put("state.header.frame_id", "odom");
        assertThat(why(call("SetEntityState", elsewhere))).isEqualTo("Poses must be in the frame 'map', not 'odom'.");
        var moving = new HashMap<>(at(8, 3));
        moving.put("state.twist.linear.x", 1.0);
        assertThat(code(call("SetEntityState", moving))).isZero();
    }

    /// Which says what is to be set.
    @Test
    void versionTwoSetsOnlyWhatItSays() {
        TypeLibrary types = TypeLibrary.of(Distribution.LYRICAL);
        MessageCodec codec = MessageCodec.of(types.get(SERVICES + "SetEntityState_Request"), types);
        var values = new HashMap<>(at(8, 3));
        values.put("state.twist.linear.x", 1.0); // which is not to be set
        Pose2d before = world.truth("r1").orElseThrow();
        for (boolean isPose : List.of(false, true)) {
            values.put("set_pose", isPose);
            byte[] response = ask(NAMES.get("SetEntityState"), codec.write(message(codec, values)))
                    .join();
            assertThat(code(read(SERVICES + "SetEntityState_Response", response)))
                    .isEqualTo(1);
            assertThat(world.truth("r1")).contains(isPose ? new Pose2d(8, 3, 0) : before);
        }
    }

    private static Map<String, Object> spawn(String uri, String name) {
        return Map.of(
                "uri", uri, "name", name, "initial_pose.pose.position.x", 9.0, "initial_pose.pose.position.y", 5.0);
    }

    @Test
    void whatIsSpawnedIsThere() {
        assertThat(call("GetSpawnables", Map.of()).messages("spawnables"))
                .extracting(each -> each.text("uri"))
                .containsExactly("rsal:pioneer", "rsal:puck");
        assertThat(code(call("GetSpawnables", Map.of("sources", List.of("file:/tmp")))))
                .isZero();
        RosMessage spawned = call("SpawnEntity", spawn("rsal:puck", "b2"));
        assertThat(why(spawned)).isEmpty();
        assertThat(code(spawned)).isEqualTo(1);
        assertThat(spawned.text("entity_name")).isEqualTo("b2");
        assertThat(world.truth("b2")).contains(new Pose2d(9, 5, 0));
        assertThat(code(call("DeleteEntity", Map.of("entity", "b2")))).isEqualTo(1);
        assertThat(world.truth("b2")).isEmpty();
    }

    @Test
    void namesAreFoundWhereTheyMayBe() {
        var renaming = new HashMap<>(spawn("rsal:puck", "b1"));
        renaming.put("allow_renaming", true);
        assertThat(call("SpawnEntity", renaming).text("entity_name")).isEqualTo("b1_2");
        renaming.put("name", "");
        assertThat(call("SpawnEntity", renaming).text("entity_name")).isEqualTo("puck");
        assertThat(call("SpawnEntity", renaming).text("entity_name")).isEqualTo("puck_2");
    }

    @Test
    void spawningThatCantBeIsRefused() {
        assertThat(code(call("SpawnEntity", spawn("rsal:puck", "b1")))).isEqualTo(101);
        assertThat(code(call("SpawnEntity", spawn("rsal:puck", "")))).isEqualTo(102);
        assertThat(code(call("SpawnEntity", spawn("rsal:puck", "a/b")))).isEqualTo(102);
        assertThat(code(call("SpawnEntity", spawn("file:/tmp/robot.sdf", "b2"))))
                .isEqualTo(103);
        assertThat(code(call("SpawnEntity", spawn("", "b2")))).isEqualTo(104);
        assertThat(code(call("SpawnEntity", Map.of("resource_string", "<sdf/>", "name", "b2"))))
                .isZero();
        RosMessage unknown = call("SpawnEntity", spawn("rsal:pionier", "b2"));
        assertThat(code(unknown)).isEqualTo(2);
        assertThat(why(unknown)).contains("rsal:pioneer");
        var elsewhere = new HashMap<>(spawn("rsal:puck", "b2"));
        elsewhere.put("entity_namespace", "other");
        assertThat(code(call("SpawnEntity", elsewhere))).isEqualTo(105);
        elsewhere.put("entity_namespace", "/b2");
        elsewhere.put("initial_pose.pose.position.x", Double.POSITIVE_INFINITY);
        assertThat(code(call("SpawnEntity", elsewhere))).isEqualTo(109);
        elsewhere.put("initial_pose.pose.position.x", -50.0);
        assertThat(why(call("SpawnEntity", elsewhere))).contains("outside of the world");
        assertThat(world.entities()).containsExactly("r1", "b1");
    }

    @Test
    void theStateIsReadAndSet() {
        assertThat(state()).isEqualTo(1);
        assertThat(code(set(1))).isEqualTo(101);
        assertThat(code(set(2))).isEqualTo(1);
        assertThat(state()).isEqualTo(2);
        assertThat(code(set(1))).isEqualTo(1);
        assertThat(control.paused).isFalse();
        assertThat(code(set(77))).isEqualTo(103);
        assertThat(code(set(3))).isEqualTo(1);
        assertThat(control.reported).endsWith("end");
        control.pausable = false;
        assertThat(code(set(2))).isZero();
        assertThat(code(set(0))).isZero();
    }

    /// As it was in the beginning: it is paused, and all is reset.
    @Test
    void itIsStoppedAndBeginsAgain() {
        control.reported.clear();
        advance(1);
        assertThat(code(set(0))).isEqualTo(1);
        assertThat(control.paused).isTrue();
        assertThat(control.reported).containsExactly("remove spawned", "restore");
        assertThat(state()).isZero();
        assertThat(times).last().isEqualTo(0L);
        assertThat(code(set(0))).isEqualTo(101);
        assertThat(code(call("StepSimulation", Map.of("steps", 1L)))).isEqualTo(3);
        assertThat(code(set(2))).isEqualTo(1);
        assertThat(state()).isEqualTo(2);
        assertThat(code(set(0))).isEqualTo(1);
        assertThat(code(set(1))).isEqualTo(1);
        assertThat(control.paused).isFalse();
        assertThat(state()).isEqualTo(1);
        assertThat(code(set(0))).isEqualTo(1);
        control.paused = false; // people let it go on by the page
        assertThat(state()).isEqualTo(1);
        control.paused = true;
        assertThat(state()).isEqualTo(2);
    }

    private CompletableFuture<byte[]> begin(long state) {
        return ask(NAMES.get("SetSimulationState"), request("SetSimulationState", Map.of("state.state", state)));
    }

    private static RosMessage changed(CompletableFuture<byte[]> response) {
        return read(SERVICES + "SetSimulationState_Response", response.join());
    }

    /// People may resume it meanwhile, as may programs.
    @Test
    void whatWasResumedIsNotStopped() {
        control.reported.clear();
        control.standing = new CompletableFuture<>();
        CompletableFuture<byte[]> stopping = begin(0);
        assertThat(stopping).isNotDone();
        assertThat(why(changed(begin(0)))).contains("still pausing");
        control.paused = false;
        control.standing.complete(null);
        control.paused = true; // again
        run.runPending();
        assertThat(code(changed(stopping))).isEqualTo(3);
        assertThat(control.reported).isEmpty();
        control.paused = false;
        assertThat(code(changed(begin(0)))).isEqualTo(1);
        assertThat(control.reported).containsExactly("remove spawned", "restore");
    }

    @Test
    void aStopWaitsUntilTheSimulationStands() {
        control.reported.clear();
        control.standing = new CompletableFuture<>();
        CompletableFuture<byte[]> stopping = begin(0);
        assertThat(control.reported).isEmpty();
        control.standing.complete(null);
        run.runPending();
        assertThat(code(changed(stopping))).isEqualTo(1);
        assertThat(control.reported).containsExactly("remove spawned", "restore");
        assertThat(state()).isZero();
    }

    /// Nobody asked meanwhile.
    @Test
    void whatGoesOnByThePageIsNoLongerStopped() {
        assertThat(code(set(0))).isEqualTo(1);
        control.paused = false;
        advance(0.1);
        control.paused = true;
        assertThat(state()).isEqualTo(2);
        CompletableFuture<byte[]> steps =
                ask(NAMES.get("StepSimulation"), request("StepSimulation", Map.of("steps", 1L)));
        control.end(1);
        assertThat(code(read(SERVICES + "StepSimulation_Response", steps.join())))
                .isEqualTo(1);
    }

    @Test
    void aStopEndsWhatWasCommanded() {
        var velocities = there.advertise(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT);
        velocities.publish(messages.twist(Twist2d.drive(0.3, 0)));
        advance(2);
        assertThat(velocity()).isGreaterThan(0.2);
        assertThat(code(set(0))).isEqualTo(1);
        assertThat(code(set(1))).isEqualTo(1);
        advance(2);
        assertThat(velocity()).isZero();
        velocities.publish(messages.twist(Twist2d.drive(0.3, 0)));
        advance(2);
        assertThat(velocity()).isGreaterThan(0.2);
    }

    private double velocity() {
        return robot().require(DriveBase.class)
                .latest()
                .orElseThrow()
                .value()
                .velocity()
                .vx();
    }

    /// Goals have the time that they began at, by the clock that there is now.
    @Test
    void goalsFromBeforeAResetAreCanceledByAnyTime() {
        advance(20);
        control.paused = true;
        CompletableFuture<byte[]> result = simulate(1, 1_000);
        assertThat(code(call("ResetSimulation", Map.of("scope", 1L)))).isEqualTo(1);
        byte[] untilOne = ByteBuffer.allocate(28)
                .putInt(0x00010000)
                .put(new byte[16])
                .order(ByteOrder.LITTLE_ENDIAN)
                .putInt(1)
                .putInt(0)
                .array();
        var _ = ask("/rsal/simulate_steps/_action/cancel_goal", untilOne);
        assertThat(ending(result)).as("canceled").containsExactly(5L, 4L);
        byte[] asked = ByteBuffer.allocate(20)
                .putInt(0x00010000)
                .put(new byte[15])
                .put((byte) 1)
                .array();
        advance(17);
        RosMessage forgotten = read(
                ACTION + "_GetResult_Response",
                ask("/rsal/simulate_steps/_action/get_result", asked).join());
        assertThat(forgotten.integer("status")).as("by the run's time").isZero();
    }

    /// All that has a time, has the new one.
    @Test
    void timeBeginsAgain() {
        var stamps = new HashMap<String, Long>();
        for (String type : List.of("LaserScan", "JointState")) {
            RosTopic topic =
                    new RosTopic(type.equals("LaserScan") ? "/r1/scan" : "/r1/joint_states", "sensor_msgs/msg/" + type);
            listen(topic, message -> stamps.put(type, RosMessages.stamp(message.message("header"))));
        }
        listen(
                new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"),
                message -> stamps.put("Odometry", RosMessages.stamp(message.message("header"))));
        listen(
                new RosTopic("/r1/ground_truth", "nav_msgs/msg/Odometry"),
                message -> stamps.put("truth", RosMessages.stamp(message.message("header"))));
        listen(
                new RosTopic("/r1/tf", "tf2_msgs/msg/TFMessage"),
                message -> stamps.put(
                        "tf",
                        RosMessages.stamp(
                                message.messages("transforms").getFirst().message("header"))));
        listen(
                new RosTopic("/diagnostics", "diagnostic_msgs/msg/DiagnosticArray"),
                message -> stamps.put("health", RosMessages.stamp(message.message("header"))));
        drive(Twist2d.drive(0.3, 0), 5);
        assertThat(stamps.values())
                .hasSizeGreaterThanOrEqualTo(5)
                .allSatisfy(each -> assertThat(each).isGreaterThan(3_900_000_000L));
        assertThat(code(call("ResetSimulation", Map.of("scope", 1L)))).isEqualTo(1);
        assertThat(times).last().isEqualTo(0L);
        assertThat(control.reported).doesNotContain("restore");
        stamps.clear();
        drive(Twist2d.drive(0.3, 0), 1.2);
        assertThat(stamps.values())
                .hasSizeGreaterThanOrEqualTo(5)
                .allSatisfy(each -> assertThat(each).isBetween(150_000_000L, 1_200_000_000L));
        assertThat(times).last().isEqualTo(1_200_000_000L);
        RosMessage state = call("GetEntityState", Map.of("entity", "r1")).message("state");
        assertThat(RosMessages.stamp(state.message("header"))).isEqualTo(1_200_000_000L);
        assertThat(state.message("twist").message("linear").number("x")).isCloseTo(0.3, within(0.02));
    }

    private void listen(RosTopic topic, Consumer<RosMessage> listener) {
        there.subscribe(topic, Profile.SENSOR_DATA, bytes -> {
            var copy = new byte[bytes.remaining()];
            bytes.get(copy);
            listener.accept(read(topic.type(), copy));
        });
    }

    private long state() {
        return call("GetSimulationState", Map.of()).message("state").integer("state");
    }

    private RosMessage set(long state) {
        return call("SetSimulationState", Map.of("state.state", state));
    }

    @Test
    void whatCanBeResetIs() {
        control.reported.clear();
        assertThat(code(call("ResetSimulation", Map.of("scope", 4L)))).isEqualTo(1);
        assertThat(code(call("ResetSimulation", Map.of("scope", 2L)))).isEqualTo(1);
        assertThat(code(call("ResetSimulation", Map.of()))).isEqualTo(1);
        assertThat(control.reported).containsExactly("remove spawned", "restore", "remove spawned", "restore");
        assertThat(code(call("ResetSimulation", Map.of("scope", 1L)))).isEqualTo(1);
        assertThat(control.reported).hasSize(4);
        assertThat(code(call("ResetSimulation", Map.of("scope", 255L)))).isEqualTo(1);
        assertThat(control.reported).hasSize(6);
        assertThat(code(call("ResetSimulation", Map.of("scope", 8L)))).isEqualTo(4);
        assertThat(control.reported).hasSize(6);
        control.reported.add("remove b1");
        RosMessage response = call("ResetSimulation", Map.of());
        assertThat(code(response)).isEqualTo(4);
        assertThat(why(response)).isEqualTo("All is back but what was deleted: b1.");
    }

    @Test
    void stepsAreAnsweredWhenTheyAreMade() {
        assertThat(code(call("StepSimulation", Map.of("steps", 1L)))).isEqualTo(3);
        control.paused = true;
        assertThat(code(call("StepSimulation", Map.of("steps", 0L)))).isEqualTo(4);
        assertThat(why(call("StepSimulation", Map.of("steps", -1L)))).contains("18446744073709551615");
        CompletableFuture<byte[]> response =
                ask(NAMES.get("StepSimulation"), request("StepSimulation", Map.of("steps", 3L)));
        assertThat(response).isNotDone();
        assertThat(code(call("StepSimulation", Map.of("steps", 1L)))).isEqualTo(3);
        control.end(3);
        assertThat(code(read(SERVICES + "StepSimulation_Response", response.join())))
                .isEqualTo(1);
        control.pausable = false;
        assertThat(code(call("StepSimulation", Map.of("steps", 1L)))).isZero();
    }

    /// @return status and result once it ends
    private CompletableFuture<byte[]> simulate(int id, long steps) {
        MessageCodec codec = MessageCodec.of(TYPES.get(ACTION + "_SendGoal_Request"), TYPES);
        var uuid = new byte[16];
        uuid[15] = (byte) id;
        byte[] goal = codec.write(message(codec, Map.of("goal_id.uuid", uuid, "goal.steps", steps)));
        byte[] accepted = ask("/rsal/simulate_steps/_action/send_goal", goal).join();
        assertThat(read(ACTION + "_SendGoal_Response", accepted).get("accepted", Boolean.class))
                .isTrue();
        byte[] asked = ByteBuffer.allocate(20).putInt(0x00010000).put(uuid).array();
        return ask("/rsal/simulate_steps/_action/get_result", asked);
    }

    private static List<Long> ending(CompletableFuture<byte[]> result) {
        RosMessage response = read(ACTION + "_GetResult_Response", result.join());
        return List.of(response.integer("status"), code(response.message("result")));
    }

    @Test
    void theActionReportsHowItGetsOn() {
        var reported = new ArrayList<Long>();
        there.subscribe(
                new RosTopic("/rsal/simulate_steps/_action/feedback", ACTION + "_FeedbackMessage"),
                Profile.DEFAULT,
                bytes -> {
                    var copy = new byte[bytes.remaining()];
                    bytes.get(copy);
                    RosMessage feedback =
                            read(ACTION + "_FeedbackMessage", copy).message("feedback");
                    reported.add(feedback.integer("completed_steps"));
                    reported.add(feedback.integer("remaining_steps"));
                });
        assertThat(ending(simulate(1, 5))).containsExactly(6L, 3L); // it is not paused
        control.paused = true;
        CompletableFuture<byte[]> result = simulate(2, 3);
        assertThat(ending(simulate(3, 1))).as("busy").containsExactly(6L, 3L);
        control.make(1, 2, 3);
        assertThat(result).isNotDone();
        control.end(3);
        assertThat(ending(result)).containsExactly(4L, 1L);
        assertThat(reported).containsExactly(1L, 2L, 2L, 1L, 3L, 0L);
        reported.clear();
        result = simulate(4, 1_000);
        for (long i = 1; i <= 1_000; i++) {
            control.make(i);
        }
        assertThat(reported).as("every tenth").hasSize(200);
        var _ = ask("/rsal/simulate_steps/_action/cancel_goal", new byte[] {0, 1, 0, 0});
        assertThat(ending(result)).as("canceled").containsExactly(5L, 4L);
    }

    /// Damaged requests of anybody: none harms the run, and all is answered afterwards as before.
    @Test
    void malformedRequestsHarmNobody() {
        int rounds = Boolean.getBoolean("rsal.test.all") ? 80_000 : 800; // times 13 services
        var random = new SplittableRandom(43);
        control.paused = true;
        for (int round = 0; round < rounds; round++) {
            for (String type : NAMES.keySet()) {
                byte[] damaged = damaged(request(type, Map.of()), random);
                var _ = ask(NAMES.get(type), damaged);
                if (control.steps.isPresent()) {
                    control.end(0);
                }
            }
            control.paused = true;
        }
        assertThat(world.truth("r1").orElseThrow().isFinite()).isTrue();
        advance(1);
        assertThat(names(call("GetEntities", Map.of())).getFirst()).isEqualTo("r1");
    }

    private static byte[] damaged(byte[] request, SplittableRandom random) {
        var damaged = new byte[Math.max(4, random.nextInt(request.length + 20))];
        System.arraycopy(request, 0, damaged, 0, Math.min(request.length, damaged.length));
        int changes = random.nextInt(6);
        for (int i = 0; i < changes; i++) {
            damaged[random.nextInt(damaged.length)] =
                    (byte) (random.nextBoolean() ? random.nextInt(8) : random.nextInt());
        }
        return damaged;
    }
}
