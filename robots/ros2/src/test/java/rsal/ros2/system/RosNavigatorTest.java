package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Health;
import rsal.device.Navigator;
import rsal.device.Navigator.Progress;
import rsal.device.Navigator.Result;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.time.LockstepScheduler;

/// A robot whose Nav2 is the test.
class RosNavigatorTest {
    private static final String ACTION = "/r1/navigate_to_pose/_action/";
    private static final Pose2d GOAL = new Pose2d(3, 1, 0.5);
    private static final Duration STEP = Duration.ofMillis(50);

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<String> sent = new ArrayList<>(); // ids of goals
    private final List<String> canceled = new ArrayList<>();
    private final List<CompletableFuture<byte[]>> results = new ArrayList<>();
    private final List<Progress> progress = new ArrayList<>();
    private boolean accepts = true;
    private Publication odometry;
    private Publication feedback;
    private Ros2System system;
    private Navigator navigator;
    private DriveBase base;

    private static String id(byte[] request) {
        return HexFormat.of().formatHex(Arrays.copyOfRange(request, 4, 20));
    }

    @BeforeEach
    void robotIsThere() {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        feedback = there.advertise(
                new RosTopic(ACTION + "feedback", "nav2_msgs/action/NavigateToPose_FeedbackMessage"), Profile.DEFAULT);
        network.serve(ACTION + "send_goal", request -> {
            sent.add(id(request));
            return CompletableFuture.completedStage(
                    new CdrWriter().bool(accepts).int32(0).int32(0).toBytes());
        });
        network.serve(ACTION + "get_result", _ -> {
            results.add(new CompletableFuture<>());
            return results.getLast();
        });
        network.serve(ACTION + "cancel_goal", request -> {
            canceled.add(id(request));
            return CompletableFuture.completedStage(
                    new CdrWriter().int8((byte) 0).int32(0).toBytes());
        });
        system = new OneRobot(network, run).system(Map.of("navigator", "own-navigator"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        var robot = found.join().getFirst();
        navigator = robot.require(Navigator.class);
        base = robot.require(DriveBase.class);
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

    private Optional<Result> drive(Runnable meanwhile) {
        GoalHandle<Progress, Result> goal = navigator.goTo(GOAL);
        goal.onFeedback(reported -> progress.add(reported.value()));
        var ended = new ArrayList<Result>();
        goal.result().thenAccept(ended::add);
        advance(0.2);
        meanwhile.run();
        advance(0.2);
        return ended.stream().findFirst();
    }

    /// @param status of action_msgs/GoalStatus
    private void end(int status, int code, String why) {
        results.getLast()
                .complete(new CdrWriter()
                        .int8((byte) status)
                        .int16((short) code)
                        .text(why)
                        .toBytes());
    }

    private void publish(String id, double x, double remaining) {
        CdrWriter message = new CdrWriter().int8s(HexFormat.of().parseHex(id));
        message.int32(0).int32(0).text("map").float64(x).float64(1).float64(0);
        message.float64(0).float64(0).float64(0).float64(1);
        message.int32(1).int32(0).int32(2).int32(0).int16((short) 0).float32((float) remaining);
        feedback.publish(message.toBytes());
    }

    @ParameterizedTest
    @CsvSource({"4, 0, Reached", "5, 0, Cancelled", "6, 208, NoPath", "6, 105, Stuck", "6, 0, Stuck"})
    void endingsAreThoseOfNav2(int status, int code, String ending) {
        Optional<Result> result = drive(() -> end(status, code, "so it is"));
        assertThat(result.orElseThrow().getClass().getSimpleName()).isEqualTo(ending);
        assertThat(sent).hasSize(1);
        assertThat(canceled).isEmpty();
    }

    @Test
    void progressIsTheFeedbackOfItsOwnGoal() {
        drive(() -> {
            publish("00".repeat(16), 9, 9);
            publish(sent.getFirst(), 1.5, 1.4);
        });
        assertThat(progress).hasSize(1);
        assertThat(progress.getFirst().mapFromBase().x()).isEqualTo(1.5);
        assertThat(progress.getFirst().remaining()).isBetween(1.39, 1.41);
    }

    @Test
    void whatIsNearEnoughIsReachedAndCanceledThere() {
        Optional<Result> result = drive(() -> {
            CdrWriter message = new CdrWriter().int8s(HexFormat.of().parseHex(sent.getFirst()));
            message.int32(0).int32(0).text("map").float64(2.9).float64(1).float64(0);
            message.float64(0).float64(0).float64(Math.sin(0.25)).float64(Math.cos(0.25));
            message.int32(1).int32(0).int32(2).int32(0).int16((short) 0).float32(0.1f);
            feedback.publish(message.toBytes());
        });
        assertThat(result.orElseThrow()).isInstanceOf(Result.Reached.class);
        assertThat(canceled).isEqualTo(sent);
    }

    @Test
    void aRefusalIsNoPath() {
        accepts = false;
        assertThat(drive(() -> {}).orElseThrow())
                .isEqualTo(new Result.NoPath("The robot's navigator refused the goal. Is it active?"));
    }

    /// A cancellation that overtakes its goal finds none.
    @Test
    void aGoalThatIsCalledOffBeforeItIsAcceptedIsCanceledAgain() {
        navigator.goTo(GOAL).cancel();
        advance(0.2);
        assertThat(canceled).containsExactly(sent.getFirst(), sent.getFirst());
        assertThat(results).isEmpty();
    }

    @Test
    void theGoalBeforeOneThatIsRefusedIsCanceled() {
        drive(() -> {
            accepts = false;
            navigator.goTo(new Pose2d(5, 5, 0));
            advance(0.2);
        });
        assertThat(canceled).containsExactly(sent.getFirst());
    }

    @Test
    void aNewGoalTakesTheOldOnesPlaceWhoseEndingIsNoFailure() {
        Optional<Result> first = drive(() -> {
            navigator.goTo(new Pose2d(5, 5, 0));
            advance(0.1);
            results.getFirst()
                    .complete(new CdrWriter()
                            .int8((byte) 6)
                            .int16((short) 0)
                            .text("preempted")
                            .toBytes());
        });
        assertThat(first.orElseThrow()).isInstanceOf(Result.Cancelled.class);
        assertThat(sent).hasSize(2);
        assertThat(navigator.goal()).contains(new Pose2d(5, 5, 0));
    }

    @Test
    void pausesAndMotorsThatAreOffHoldTheGoalBack() {
        assertThat(drive(navigator::pause)).isEmpty();
        assertThat(canceled).isEqualTo(sent);
        navigator.resume();
        advance(0.1);
        assertThat(sent).hasSize(2);
        base.enable(false);
        advance(0.1);
        assertThat(canceled).hasSize(2);
        base.enable(true);
        advance(0.1);
        assertThat(sent).hasSize(3);
        assertThat(navigator.goal()).contains(GOAL);
    }

    @Test
    void nobodyThereIsLostAndEndsTheGoal() {
        assertThat(navigator.health().isOk()).isTrue();
        Optional<Result> result = drive(() -> {
            network.forget(ACTION + "send_goal");
            advance(1.5);
        });
        assertThat(result.orElseThrow()).isInstanceOf(Result.Stuck.class);
        assertThat(navigator.health()).isInstanceOf(Health.Lost.class);
    }

    @Test
    void aGoalThatNobodyAnswersEndsAndIsCanceled() {
        network.serve(ACTION + "send_goal", request -> {
            sent.add(id(request));
            return new CompletableFuture<>();
        });
        Optional<Result> result = drive(() -> advance(5.2));
        assertThat(result.orElseThrow())
                .isInstanceOfSatisfying(
                        Result.Stuck.class,
                        stuck -> assertThat(stuck.why()).isEqualTo("The robot did not answer within 5 s."));
        assertThat(canceled).isEqualTo(sent);
    }

    /// As when its computer hangs: the network still has it.
    @Test
    void aGoalOfWhichNothingIsHeardAnyMoreEndsAndIsCanceled() {
        Optional<Result> result = drive(() -> {
            advance(20); // servers need not tell how a goal gets on
            publish(sent.getFirst(), 1.5, 1.4);
            advance(9);
            assertThat(navigator.goal()).isPresent();
            advance(2);
        });
        assertThat(result.orElseThrow())
                .isInstanceOfSatisfying(
                        Result.Stuck.class,
                        stuck -> assertThat(stuck.why())
                                .isEqualTo("The robot has reported nothing about the goal for 10 s."));
        assertThat(canceled).isEqualTo(sent);
    }

    @Test
    void closingCancelsWhatIsUnderWay() {
        drive(() -> {});
        system.close();
        assertThat(canceled).isEqualTo(sent);
    }
}
