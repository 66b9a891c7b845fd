package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.stream.Stream;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Health;
import rsal.device.Planner;
import rsal.device.Planner.Result;
import rsal.robot.Robot;
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
import rsal.ros2.message.PathMessage;
import rsal.ros2.message.RosMessages;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.time.LockstepScheduler;

/// A robot whose planner server of Nav2 is the test.
class RosPlannerTest {
    private static final String TYPE = "nav2_msgs/action/ComputePathToPose";
    private static final String ACTION = "/r1/compute_path_to_pose/_action/";
    private static final Pose2d START = new Pose2d(1, 2, 0);
    private static final Pose2d GOAL = new Pose2d(3, 1, 0.5);
    private static final Duration STEP = Duration.ofMillis(50);
    private static final int SUCCEEDED = 4;
    private static final int ABORTED = 6;

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<byte[]> sent = new ArrayList<>();
    private final List<String> canceled = new ArrayList<>();
    private final List<CompletableFuture<byte[]>> results = new ArrayList<>();
    private boolean accepts = true;
    private Publication odometry;
    private Ros2System system;
    private Robot robot;

    private void begin(Distribution distribution, boolean isServed) {
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        if (isServed) {
            there.advertise(new RosTopic(ACTION + "feedback", TYPE + "_FeedbackMessage"), Profile.DEFAULT);
        }
        network.serve(ACTION + "send_goal", request -> {
            sent.add(request);
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
        system = new OneRobot(network, run, Optional.of(distribution), GripperSettings.USUAL)
                .system(Map.of("planner", "own-planner"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        robot = found.join().getFirst();
    }

    private Planner begin() {
        begin(Distribution.JAZZY, true);
        return robot.require(Planner.class);
    }

    @AfterEach
    void close() {
        system.close();
    }

    private static String id(byte[] request) {
        return HexFormat.of().formatHex(Arrays.copyOfRange(request, 4, 20));
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            run.advance(STEP);
        }
    }

    private List<Result> ask(Planner planner, Pose2d goal) {
        var answers = new ArrayList<Result>();
        planner.plan(START, goal).thenAccept(answers::add);
        advance(0.2);
        return answers;
    }

    private void end(int status, int code, String why, String frame, Pose2d... poses) {
        CdrWriter result = new CdrWriter().int8((byte) status);
        PathMessage.write(result, run.instant(), frame, List.of(poses));
        results.getLast()
                .complete(result.int32(0).int32(5).int16((short) code).text(why).toBytes());
        advance(0.2);
    }

    /// As each distribution defines it: Lyrical has further poses in the middle.
    @ParameterizedTest
    @EnumSource
    void aRequestIsTheGoalOfTheRobotsDistribution(Distribution distribution) throws InvalidCdr {
        begin(distribution, true);
        ask(robot.require(Planner.class), GOAL);
        TypeLibrary types = TypeLibrary.of(distribution);
        MessageCodec codec = MessageCodec.of(types.get(TYPE + "_SendGoal_Request"), types);
        CdrReader reader = CdrReader.of(sent.getFirst());
        RosMessage goal = codec.read(reader).message("goal");
        assertThat(reader.isAtEnd(4)).isTrue();
        assertThat(goal.fields().containsKey("viapoints")).isEqualTo(distribution == Distribution.LYRICAL);
        assertThat(goal.get("use_start", Boolean.class)).isTrue();
        assertThat(goal.text("planner_id")).isEmpty();
        assertThat(goal.message("start").message("pose").message("position").number("y"))
                .isEqualTo(2);
        RosMessage place = goal.message("goal");
        assertThat(place.message("header").text("frame_id")).isEqualTo("map");
        assertThat(place.message("pose").message("orientation").number("z")).isCloseTo(Math.sin(0.25), within(1e-9));
    }

    @Test
    void aPathCostsItsLengthAndMayEndNearTheGoal() {
        Planner planner = begin();
        List<Result> answers = ask(planner, GOAL);
        end(SUCCEEDED, 0, "", "map", START, new Pose2d(2, 2, 0), new Pose2d(3, 2, 0));
        assertThat(answers).singleElement().isInstanceOfSatisfying(Result.Found.class, found -> {
            assertThat(found.path().points()).containsExactly(new Point2d(1, 2), new Point2d(2, 2), new Point2d(3, 2));
            assertThat(found.cost()).isEqualTo(2);
            assertThat(found.offGoal()).isEqualTo(1);
        });
        ask(planner, GOAL);
        assertThat(canceled).isEmpty();
    }

    @ParameterizedTest
    @CsvSource({
        "208, '', No path leads to the goal. (error 208 of Nav2)",
        "204, '', The goal is outside of the map. (error 204 of Nav2)",
        "206, too near, too near (error 206 of Nav2)",
        "4711, '', The robot's planner failed. (error 4711 of Nav2)"
    })
    void errorsOfNav2AreNoPath(int code, String why, String expected) {
        List<Result> answers = ask(begin(), GOAL);
        end(ABORTED, code, why, "map");
        assertThat(answers).containsExactly(new Result.NoPath(expected));
    }

    @Test
    void humbleGivesNoReason() {
        begin(Distribution.HUMBLE, true);
        List<Result> answers = ask(robot.require(Planner.class), GOAL);
        results.getLast()
                .complete(PathMessage.write(new CdrWriter().int8((byte) ABORTED), run.instant(), "", List.of())
                        .int32(0)
                        .int32(0)
                        .toBytes());
        advance(0.2);
        assertThat(answers).containsExactly(new Result.NoPath("The robot's planner found no path."));
        assertThat(sent).hasSize(1);
    }

    @Test
    void answersThatAreNoPathsAreNoPath() {
        Planner planner = begin();
        List<Result> answers = new ArrayList<>(ask(planner, GOAL));
        for (Runnable bad : List.<Runnable>of(
                () -> end(SUCCEEDED, 0, "", "odom", START, GOAL),
                () -> end(SUCCEEDED, 0, "", "map"),
                () -> end(SUCCEEDED, 0, "", "map", START, new Pose2d(Double.NaN, 0, 0)),
                () -> {
                    results.getLast().complete(new byte[] {0, 1, 0, 0, 4, 0, 0, 0, 0, 0, 0, 0, 9, 9, 9, 9});
                    advance(0.2);
                })) {
            List<Result> one = ask(planner, GOAL);
            bad.run();
            answers.addAll(one);
            end(SUCCEEDED, 0, "", "map", START, GOAL); // the next one
        }
        assertThat(answers).isNotEmpty().hasOnlyElementsOfType(Result.NoPath.class);
    }

    /// The planner of Nav2 works on one goal, and a second one may end it.
    @Test
    void requestsWaitForEachOther() {
        Planner planner = begin();
        List<Result> first = ask(planner, GOAL);
        List<Result> second = ask(planner, START);
        assertThat(sent).hasSize(1);
        end(SUCCEEDED, 0, "", "map", START, GOAL);
        assertThat(sent).hasSize(2);
        end(ABORTED, 205, "", "map");
        assertThat(first).singleElement().isInstanceOf(Result.Found.class);
        assertThat(second).singleElement().isInstanceOf(Result.NoPath.class);
    }

    /// Nav2 ends a goal without an error when another program's goal takes its place.
    @Test
    void aRequestThatAnotherGoalEndedIsSentAgainButNotForever() {
        List<Result> answers = ask(begin(), GOAL);
        for (int i = 0; i < 3; i++) {
            assertThat(answers).isEmpty();
            assertThat(sent).hasSize(i + 1);
            end(ABORTED, 0, "", "map");
        }
        assertThat(answers).singleElement().isInstanceOf(Result.NoPath.class);
        assertThat(sent).hasSize(3);
    }

    @Test
    void aRefusalIsNoPath() {
        Planner planner = begin();
        accepts = false;
        assertThat(ask(planner, GOAL))
                .containsExactly(new Result.NoPath("The robot's planner refused the request. Is it active?"));
    }

    @Test
    void aRequestWithoutAnAnswerEndsAndIsCanceled() {
        Planner planner = begin();
        List<Result> slow = ask(planner, GOAL);
        List<Result> next = ask(planner, GOAL);
        advance(10);
        assertThat(slow).containsExactly(new Result.NoPath("The robot's planner found no path within 10 s."));
        assertThat(canceled).containsExactly(id(sent.getFirst()));
        end(SUCCEEDED, 0, "", "map", START, GOAL);
        assertThat(next).singleElement().isInstanceOf(Result.Found.class);
    }

    @Test
    void aPlannerThatNeverAnswersHoldsNobodyForever() {
        Planner planner = begin();
        List<List<Result>> answers =
                Stream.generate(() -> ask(planner, GOAL)).limit(20).toList();
        advance(31);
        assertThat(answers).allSatisfy(each -> assertThat(each).singleElement().isInstanceOf(Result.NoPath.class));
        assertThat(sent).hasSize(3);
        List<Result> later = ask(planner, GOAL);
        end(SUCCEEDED, 0, "", "map", START, GOAL);
        assertThat(later).singleElement().isInstanceOf(Result.Found.class);
    }

    @Test
    void nobodyThereIsLostAndEndsAllRequests() {
        Planner planner = begin();
        assertThat(planner.health().isOk()).isTrue();
        List<Result> answers = ask(planner, GOAL);
        List<Result> waiting = ask(planner, GOAL);
        network.forget(ACTION + "send_goal");
        advance(1.5);
        var nobody = new Result.NoPath("Nobody serves '/r1/compute_path_to_pose'.");
        assertThat(planner.health()).isInstanceOf(Health.Lost.class);
        assertThat(answers).containsExactly(nobody);
        assertThat(waiting).containsExactly(nobody);
        assertThat(ask(planner, GOAL)).containsExactly(nobody);
    }

    @Test
    void placesWithoutAValueAreNotAskedAbout() {
        assertThat(ask(begin(), new Pose2d(Double.NaN, 0, 0))).singleElement().isInstanceOf(Result.NoPath.class);
        assertThat(sent).isEmpty();
    }

    @Test
    void closingEndsAllRequests() {
        Planner planner = begin();
        List<Result> answers = ask(planner, GOAL);
        List<Result> waiting = ask(planner, GOAL);
        system.close();
        assertThat(answers).singleElement().isInstanceOf(Result.NoPath.class);
        assertThat(waiting).singleElement().isInstanceOf(Result.NoPath.class);
        assertThat(canceled).containsExactly(id(sent.getFirst()));
    }

    @Test
    void aRobotWithoutAPlannerIsUsedWithoutOne() {
        begin(Distribution.JAZZY, false);
        assertThat(robot.find(Planner.class)).isEmpty();
    }
}
