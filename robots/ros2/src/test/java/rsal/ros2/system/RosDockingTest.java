package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Docking;
import rsal.device.Docking.Progress;
import rsal.device.Docking.Result;
import rsal.device.GoalHandle;
import rsal.device.Health;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.LockstepScheduler;

/// A robot whose docking server is the test.
class RosDockingTest {
    private static final String DOCK = "/r1/dock_robot/_action/";
    private static final Duration STEP = Duration.ofMillis(50);
    private static final TypeLibrary TYPES = TypeLibrary.of(Distribution.JAZZY);
    private static final MessageCodec REQUEST =
            MessageCodec.of(TYPES.get("nav2_msgs/action/DockRobot_SendGoal_Request"), TYPES);

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<RosMessage> goals = new ArrayList<>();
    private final List<String> canceled = new ArrayList<>();
    private final List<CompletableFuture<byte[]>> results = new ArrayList<>();
    private boolean accepts = true;
    private Publication odometry;
    private Publication feedback;
    private Ros2System system;
    private Docking docking;

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        feedback = there.advertise(
                new RosTopic(DOCK + "feedback", "nav2_msgs/action/DockRobot_FeedbackMessage"), Profile.DEFAULT);
        network.serve(DOCK + "send_goal", request -> {
            goals.add(read(request));
            return CompletableFuture.completedStage(
                    new CdrWriter().bool(accepts).int32(0).int32(0).toBytes());
        });
        network.serve(DOCK + "get_result", _ -> {
            results.add(new CompletableFuture<>());
            return results.getLast();
        });
        network.serve(DOCK + "cancel_goal", request -> {
            canceled.add(HexFormat.of().formatHex(Arrays.copyOfRange(request, 4, 20)));
            return CompletableFuture.completedStage(
                    new CdrWriter().int8((byte) 0).int32(0).toBytes());
        });
        system = new OneRobot(network, run).system(Map.of("dock", "own-docking"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        docking = found.join().getFirst().require(Docking.class);
    }

    @AfterEach
    void close() {
        system.close();
    }

    private static RosMessage read(byte[] request) {
        try {
            return REQUEST.read(CdrReader.of(request));
        } catch (InvalidCdr e) {
            throw new AssertionError(e);
        }
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            run.advance(STEP);
        }
    }

    private void end(int status, boolean isDone, int code, String message) {
        results.getLast()
                .complete(new CdrWriter()
                        .int8((byte) status)
                        .bool(isDone)
                        .int16((short) code)
                        .int16((short) 0)
                        .text(message)
                        .toBytes());
        advance(0.1);
    }

    private static Result result(GoalHandle<Progress, Result> handle) {
        return handle.result().toCompletableFuture().join();
    }

    @Test
    void aGoalByNameAndOneByPlaceAreThoseOfNav2() {
        docking.dock("home");
        advance(0.1);
        RosMessage byName = goals.getLast().message("goal");
        assertThat(byName.get("use_dock_id", Boolean.class)).isTrue();
        assertThat(byName.text("dock_id")).isEqualTo("home");
        assertThat(byName.get("navigate_to_staging_pose", Boolean.class)).isTrue();
        assertThat(byName.number("max_staging_time")).isEqualTo(1_000);
        docking.dock(new Pose2d(1, 2, 0), "charger");
        advance(0.1);
        RosMessage byPlace = goals.getLast().message("goal");
        assertThat(byPlace.get("use_dock_id", Boolean.class)).isFalse();
        assertThat(byPlace.text("dock_type")).isEqualTo("charger");
        RosMessage pose = byPlace.message("dock_pose");
        assertThat(pose.message("header").text("frame_id")).isEqualTo("map");
        assertThat(pose.message("pose").message("position").number("y")).isEqualTo(2);
        assertThat(canceled).as("the first one").hasSize(1);
    }

    /// The docking server of Nav2 tells a stage once, and then nothing for as long as the robot drives.
    @Test
    void silenceIsNoEnd() {
        var stages = new ArrayList<Docking.Stage>();
        GoalHandle<Progress, Result> handle = docking.dock("home");
        handle.onFeedback(reported -> stages.add(reported.value().stage()));
        advance(0.1);
        for (int state : new int[] {1, 3, 77}) {
            feedback.publish(new CdrWriter()
                    .int8s(goals.getLast().message("goal_id").get("uuid", byte[].class))
                    .int16((short) state)
                    .int32(0)
                    .int32(0)
                    .int16((short) 2)
                    .toBytes());
            advance(0.1);
        }
        advance(60);
        assertThat(stages).containsExactly(Docking.Stage.APPROACHING, Docking.Stage.MOVING, Docking.Stage.BEGINNING);
        end(4, true, 0, "");
        assertThat(result(handle)).isEqualTo(new Result.Reached());
    }

    @ParameterizedTest
    @CsvSource(quoteCharacter = '`', textBlock = """
            6, 904, ``,        The robot gave up: it did not detect the dock (error 904 of Nav2).
            6, 999, low light, The robot gave up: low light (error 999 of Nav2).
            6, 12,  ``,        The robot gave up: it does not say why (error 12 of Nav2).
            4, 901, ``,        The robot gave up: it knows no such dock (error 901 of Nav2).
            """)
    void errorsOfNav2AreFailuresWithTheirReason(int status, int code, String message, String why) {
        GoalHandle<Progress, Result> handle = docking.dock("home");
        advance(0.1);
        end(status, false, code, message);
        assertThat(result(handle)).isEqualTo(new Result.Failed(why));
    }

    @Test
    void whatIsRefusedOrNotServedFails() {
        accepts = false;
        GoalHandle<Progress, Result> refused = docking.dock("home");
        advance(0.1);
        assertThat(result(refused))
                .isEqualTo(new Result.Failed("The robot's docking server refused the goal. Is it active?"));
        assertThat(result(docking.undock())).isEqualTo(new Result.Failed("Nobody serves '/r1/undock_robot'."));
    }

    @Test
    void aServerThatIsGoneEndsTheGoal() {
        GoalHandle<Progress, Result> handle = docking.dock("home");
        advance(0.1);
        network.forget(DOCK + "send_goal");
        advance(1.5);
        assertThat(result(handle)).isEqualTo(new Result.Failed("Nobody serves '/r1/dock_robot'."));
        assertThat(docking.health()).isEqualTo(new Health.Lost("Nobody serves '/r1/dock_robot'."));
        assertThat(canceled).hasSize(1);
    }
}
