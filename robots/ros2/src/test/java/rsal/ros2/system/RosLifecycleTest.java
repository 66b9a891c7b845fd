package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.RosMessages;
import rsal.ros2.message.RosMessages.Transform;
import rsal.time.LockstepScheduler;

/// A robot whose Nav2 is there, and not always active.
class RosLifecycleTest {
    private static final int UNCONFIGURED = 1;
    private static final int INACTIVE = 2;
    private static final int ACTIVE = 3;
    private static final Duration STEP = Duration.ofMillis(50);

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final Map<String, Integer> states = new HashMap<>(); // of nodes
    private final Map<String, Publication> events = new HashMap<>();
    private final List<String> asked = new ArrayList<>();
    private Publication odometry;
    private Publication transforms;
    private Ros2System system;
    private Robot robot;

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        transforms = there.advertise(new RosTopic("/r1/tf", "tf2_msgs/msg/TFMessage"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        there.advertise(
                new RosTopic(
                        "/r1/navigate_to_pose/_action/feedback", "nav2_msgs/action/NavigateToPose_FeedbackMessage"),
                Profile.DEFAULT);
        for (String service : List.of("send_goal", "get_result", "cancel_goal")) {
            network.serve("/r1/navigate_to_pose/_action/" + service, _ -> new CompletableFuture<>());
        }
        system = new OneRobot(network, run).system(Map.of("navigator", "own-navigator", "localizer", "own-localizer"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        robot = found.join().getFirst();
    }

    @AfterEach
    void close() {
        system.close();
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            transforms.publish(messages.transforms(
                    List.of(new Transform(run.instant(), "map", "odom", FrameTransform.of(Pose2d.ORIGIN)))));
            run.advance(STEP);
        }
    }

    private void start(String node, int state) {
        states.put(node, state);
        serve(node);
        events.put(
                node,
                there.advertise(
                        new RosTopic("/r1/%s/transition_event".formatted(node), "lifecycle_msgs/msg/TransitionEvent"),
                        Profile.DEFAULT));
    }

    private void serve(String node) {
        network.serve("/r1/%s/get_state".formatted(node), request -> {
            assertThat(request).as("a request without fields").hasSize(5);
            asked.add(node);
            return CompletableFuture.completedStage(new CdrWriter()
                    .int8(states.get(node).byteValue())
                    .text("in the words of ROS")
                    .toBytes());
        });
    }

    /// As a node does it: what has happened is said as an event.
    private void change(String node, int state) {
        states.put(node, state);
        events.get(node).publish(new CdrWriter().int64(0).toBytes());
    }

    private Health navigator() {
        return robot.require(Navigator.class).health();
    }

    private Health localizer() {
        return robot.require(Localizer.class).health();
    }

    @Test
    void withoutNodesNobodyIsAlarmedAndNothingIsAsked() {
        assertThat(navigator()).isEqualTo(Health.ok());
        assertThat(localizer()).isEqualTo(Health.ok());
        assertThat(asked).isEmpty();
    }

    @Test
    void aNavigatorIsLostAsLongAsItsNodeIsNotActive() {
        start("bt_navigator", UNCONFIGURED);
        advance(0.2);
        assertThat(navigator()).isEqualTo(new Health.Lost("'/r1/bt_navigator' is unconfigured."));
        assertThat(localizer()).as("which does not need it").isEqualTo(Health.ok());
        change("bt_navigator", INACTIVE);
        advance(0.1);
        assertThat(navigator()).isEqualTo(new Health.Lost("'/r1/bt_navigator' is inactive."));
        change("bt_navigator", ACTIVE);
        advance(0.1);
        assertThat(navigator()).isEqualTo(Health.ok());
    }

    /// An event can get lost.
    @Test
    void aStateIsAskedForAgainEveryTwoSeconds() {
        start("bt_navigator", ACTIVE);
        advance(1);
        states.put("bt_navigator", INACTIVE);
        advance(2.1);
        assertThat(navigator()).isInstanceOf(Health.Lost.class);
        assertThat(asked).hasSize(2);
    }

    @Test
    void aNavigatorNeedsThoseThatPlanAndDriveToo() {
        start("bt_navigator", ACTIVE);
        start("controller_server", ACTIVE);
        start("planner_server", INACTIVE);
        advance(0.2);
        assertThat(navigator()).isEqualTo(new Health.Lost("'/r1/planner_server' is inactive."));
        change("planner_server", ACTIVE);
        advance(0.2);
        assertThat(navigator()).isEqualTo(Health.ok());
        change("controller_server", 13);
        advance(0.2);
        assertThat(navigator()).isEqualTo(new Health.Lost("'/r1/controller_server' is being activated."));
    }

    @Test
    void aLocalizerNeedsAmclOrSlamToolbox() {
        start("amcl", INACTIVE);
        advance(0.2);
        assertThat(localizer()).isEqualTo(new Health.Lost("'/r1/amcl' is inactive."));
        start("slam_toolbox", ACTIVE);
        advance(0.2);
        assertThat(localizer()).isEqualTo(Health.ok());
    }

    @Test
    void aNodeThatIsGoneOrDoesNotAnswerAlarmsNobody() {
        start("bt_navigator", INACTIVE);
        advance(0.2);
        assertThat(navigator().isOk()).isFalse();
        network.serve("/r1/bt_navigator/get_state", _ -> new CompletableFuture<>());
        advance(8);
        assertThat(navigator()).as("its state is not known").isEqualTo(Health.ok());
        network.serve("/r1/bt_navigator/get_state", _ -> CompletableFuture.completedStage(new byte[] {1, 2}));
        advance(6);
        assertThat(navigator()).as("damaged").isEqualTo(Health.ok());
        serve("bt_navigator");
        advance(3);
        assertThat(navigator().isOk()).isFalse();
        network.forget("/r1/bt_navigator/get_state");
        events.get("bt_navigator").close();
        advance(0.2);
        assertThat(navigator()).as("gone").isEqualTo(Health.ok());
    }
}
