package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.GripperState;
import rsal.data.GripperState.Paddles;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.GoalHandle;
import rsal.device.Gripper;
import rsal.device.Gripper.Result;
import rsal.device.Health;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.ros2.setting.GripperSettings;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.RobotSystemProvider;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.testkit.contract.RobotBench;
import rsal.time.LockstepScheduler;

/// A gripper of `ros2_control` as those of real robots are: one action, without beams, lift and our names.
class RosGripperTest {
    private static final Duration STEP = Duration.ofMillis(50);
    private static final String ACTION = "/r1/hand/gripper_cmd/_action/";
    private static final double OPEN = 0.019; // m, as of a small arm's gripper
    private static final double CLOSED = -0.01;
    private static final GripperSettings SETTINGS = new GripperSettings(
            "hand/gripper_cmd", "left_finger", OptionalDouble.of(OPEN), CLOSED, 5, "lift/gripper_cmd", "lift");

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<Double> wanted = new ArrayList<>(); // position, effort, position, …
    private final List<CompletableFuture<byte[]>> results = new ArrayList<>();
    private int canceled;
    private Publication odometry;
    private Publication joints;
    private Ros2System system;
    private Gripper gripper;

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        joints = there.advertise(new RosTopic("/joint_states", "sensor_msgs/msg/JointState"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        there.advertise(
                new RosTopic(ACTION + "feedback", "control_msgs/action/GripperCommand_FeedbackMessage"),
                Profile.DEFAULT);
        network.serve(ACTION + "send_goal", request -> {
            ByteBuffer command = ByteBuffer.wrap(request).order(ByteOrder.LITTLE_ENDIAN);
            wanted.add(command.getDouble(20));
            wanted.add(command.getDouble(28));
            return CompletableFuture.completedStage(
                    new CdrWriter().bool(true).int32(0).int32(0).toBytes());
        });
        network.serve(ACTION + "get_result", _ -> {
            results.add(new CompletableFuture<>());
            return results.getLast();
        });
        network.serve(ACTION + "cancel_goal", _ -> {
            canceled++;
            return CompletableFuture.completedStage(
                    new CdrWriter().int8((byte) 0).int32(0).toBytes());
        });
        system = new OneRobot(network, run, Optional.empty(), SETTINGS).system(Map.of("gripper", "pioneer-gripper"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        gripper = found.join().getFirst().require(Gripper.class);
    }

    @AfterEach
    void close() {
        system.close();
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            run.advance(STEP);
        }
    }

    private void joint(String name, double position) {
        CdrWriter message = RosMessages.write(new CdrWriter(), run.instant()).text("");
        message.int32(2).text("wheel").text(name).int32(2).float64(3).float64(position);
        joints.publish(message.int32(0).int32(0).toBytes());
    }

    private void end(int status, double position, boolean stalled) {
        results.getLast()
                .complete(new CdrWriter()
                        .int8((byte) status)
                        .float64(position)
                        .float64(5)
                        .bool(stalled)
                        .bool(!stalled)
                        .toBytes());
    }

    private static List<Result> endings(GoalHandle<GripperState, Result> goal) {
        var endings = new ArrayList<Result>();
        goal.result().thenAccept(endings::add);
        return endings;
    }

    private GripperState state() {
        return gripper.latest().orElseThrow().value();
    }

    /// A controller that is set to allow stalling succeeds then, another one aborts.
    @ParameterizedTest
    @ValueSource(ints = {4, 6})
    void whatStopsItsPaddlesIsHeldUntilTheyOpen(int status) {
        List<Result> closed = endings(gripper.close());
        advance(0.2);
        assertThat(wanted).containsExactly(CLOSED, 5.0);
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSING);
        end(status, 0.004, true);
        advance(0.2);
        assertThat(closed)
                .singleElement()
                .isInstanceOfSatisfying(
                        Result.Reached.class,
                        reached -> assertThat(reached.state().holding()).isTrue());
        assertThat(state().holding() && state().innerBeamBroken()).isTrue();
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
        assertThat(state().closed()).isCloseTo((0.019 - 0.004) / 0.029, within(1e-9));
        List<Result> opened = endings(gripper.open());
        advance(0.2);
        end(4, OPEN, false);
        advance(0.2);
        assertThat(opened).singleElement().isInstanceOf(Result.Reached.class);
        assertThat(state().holding()).isFalse();
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
    }

    @Test
    void closedOnNothingItHoldsNothing() {
        gripper.close();
        advance(0.2);
        end(4, CLOSED, false);
        advance(0.2);
        assertThat(state().holding()).isFalse();
        assertThat(state().paddles()).isEqualTo(Paddles.CLOSED);
    }

    @Test
    void itsStateIsThatOfItsJoint() {
        joint("left_finger", OPEN);
        advance(0.1);
        assertThat(state().paddles()).isEqualTo(Paddles.OPEN);
        joint("left_finger", 0.0045);
        joint("another", 100);
        advance(0.1);
        assertThat(state().closed()).isCloseTo(0.5, within(1e-9));
        assertThat(state().paddles()).isEqualTo(Paddles.STOPPED);
    }

    @Test
    void whereItIsIsNotKnownBeforeAnythingIsReported() {
        assertThat(state().closed()).isNaN();
        assertThat(state().paddles()).isEqualTo(Paddles.STOPPED);
    }

    @ParameterizedTest
    @CsvSource({"6, false", "4, true"})
    void anAbortedGoalIsStuckButOpeningIsNeverHolding(int status, boolean isReached) {
        List<Result> opened = endings(gripper.open());
        advance(0.2);
        end(status, 0.004, true);
        advance(0.2);
        assertThat(opened).singleElement().isInstanceOf(isReached ? Result.Reached.class : Result.Stuck.class);
        assertThat(state().holding()).isFalse();
    }

    @Test
    void oneThatNeverGetsThereIsStuckAndCanceled() {
        List<Result> closed = endings(gripper.close());
        advance(16);
        assertThat(closed).singleElement().isInstanceOf(Result.Stuck.class);
        assertThat(canceled).isEqualTo(1);
    }

    @Test
    void withoutALiftLoweringIsDoneAndLiftingIsNot() {
        assertThat(endings(gripper.lower())).singleElement().isInstanceOf(Result.Reached.class);
        assertThat(endings(gripper.lift())).singleElement().isInstanceOf(Result.Stuck.class);
    }

    @Test
    void whenNobodyServesItAnyMoreItIsLostAndItsGoalsAreStuck() {
        List<Result> closed = endings(gripper.close());
        advance(0.2);
        network.forget(ACTION + "send_goal");
        advance(1.5);
        assertThat(gripper.health()).isInstanceOf(Health.Lost.class);
        assertThat(closed).singleElement().isInstanceOf(Result.Stuck.class);
        joint("left_finger", OPEN);
        advance(0.2);
        assertThat(gripper.health()).isInstanceOf(Health.Lost.class);
    }

    @ParameterizedTest
    @ValueSource(strings = {"0.02", "a b", "0.1 0.1", "NaN 0", "1 2 3"})
    void positionsThatAreNoneAreRefused(String positions) {
        var provider = new Ros2Provider();
        var config = new RobotSystemProvider.Config(
                Arguments.of(provider.parameters(), Map.of("gripperPositions", positions)),
                Scene.of(RobotBench.WORLD.grid()),
                List.of(OneRobot.spec(Map.of("gripper", "pioneer-gripper"))),
                1);
        assertThatThrownBy(() -> provider.create(config, run))
                .isInstanceOfSatisfying(
                        InvalidRobots.class,
                        invalid -> assertThat(invalid.problems())
                                .singleElement()
                                .satisfies(problem -> assertThat(problem.message())
                                        .contains("'gripperPositions'", "'%s'".formatted(positions))));
    }
}
