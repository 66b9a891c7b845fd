package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.random.RandomGenerator;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.Planner;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.RosLink;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.message.StampedPose;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// A robot of ours whose planner the test is, asked by programs of Nav2.
class PublishedPlannerTest extends RobotBench {
    private static final String TYPE = "nav2_msgs/action/ComputePathToPose";
    private static final String ACTION = "/r1/compute_path_to_pose/_action/";
    private static final TypeLibrary JAZZY = TypeLibrary.of(Distribution.JAZZY);
    private static final Pose2d GOAL = new Pose2d(5, 3, 1);
    private static final int SUCCEEDED = 4;
    private static final int CANCELED = 5;
    private static final int ABORTED = 6;

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final Asked planner = new Asked("planner");
    private final Asked other = new Asked("other");
    private Bridge bridge;
    private int goals;

    /// Answers when the test does.
    private static final class Asked extends DeviceCore implements Planner {
        private final List<Pose2d> starts = new ArrayList<>();
        private final List<Pose2d> ends = new ArrayList<>();
        private final List<CompletableFuture<Result>> answers = new ArrayList<>();

        Asked(String name) {
            super(new DeviceInfo("r1", name, "test"));
        }

        @Override
        public CompletionStage<Result> plan(Pose2d mapFromStart, Pose2d mapFromGoal) {
            starts.add(mapFromStart);
            ends.add(mapFromGoal);
            answers.add(new CompletableFuture<>());
            return answers.getLast();
        }

        /// Straight to where it was asked.
        void answer() {
            var path = new Path2d(
                    List.of(starts.getLast().position(), ends.getLast().position()));
            answers.getLast().complete(new Result.Found(path, path.length(), 0));
        }
    }

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @BeforeEach
    void publish() {
        Robot robot = robot().with(planner).with(other);
        bridge = PublishedRobots.publish(List.of(robot), WORLD.grid(), network.join(), run);
        advance(0.3);
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    private static RosMessage goal(Distribution distribution, Pose2d start, Pose2d goal) {
        TypeLibrary types = TypeLibrary.of(distribution);
        RosMessage zero = MessageCodec.of(types.get(TYPE + "_Goal"), types).zero();
        return zero.with("start", StampedPose.of(zero.message("start"), "map", start))
                .with("goal", StampedPose.of(zero.message("goal"), "map", goal))
                .with("use_start", true);
    }

    private CompletableFuture<byte[]> send(RosMessage goal) {
        return send(Distribution.JAZZY, goal);
    }

    private CompletableFuture<byte[]> send(Distribution distribution, RosMessage goal) {
        TypeLibrary types = TypeLibrary.of(distribution);
        goals++;
        CdrWriter request = new CdrWriter().int8s(id());
        MessageCodec.of(types.get(TYPE + "_Goal"), types).write(goal, request);
        there.client(ACTION + "send_goal", TYPE + "_SendGoal").call(request.toBytes());
        run.runPending();
        CompletableFuture<byte[]> result = there.client(ACTION + "get_result", TYPE + "_GetResult")
                .call(new CdrWriter().int8s(id()).toBytes())
                .toCompletableFuture();
        run.runPending();
        return result;
    }

    private byte[] id() {
        var id = new byte[16];
        id[0] = (byte) goals;
        id[1] = (byte) (goals >> 8);
        return id;
    }

    private RosMessage result(CompletableFuture<byte[]> answer) throws InvalidCdr {
        advance(0.1);
        assertThat(answer).isCompleted();
        return MessageCodec.of(JAZZY.get(TYPE + "_GetResult_Response"), JAZZY).read(CdrReader.of(answer.join()));
    }

    private void assertFails(RosMessage goal, int code) throws InvalidCdr {
        RosMessage response = result(send(goal));
        assertThat(response.integer("status")).isEqualTo(ABORTED);
        assertThat(response.message("result").integer("error_code")).isEqualTo(code);
        assertThat(response.message("result").text("error_msg")).isNotBlank();
        assertThat(planner.starts).isEmpty();
    }

    @ParameterizedTest
    @EnumSource
    void goalsOfAllDistributionsAreUnderstood(Distribution distribution) throws InvalidCdr {
        CompletableFuture<byte[]> answer = send(distribution, goal(distribution, START, GOAL));
        assertThat(planner.starts)
                .singleElement()
                .satisfies(start -> assertThat(start.isNear(START, 1e-9, 1e-9)).isTrue());
        assertThat(planner.ends)
                .singleElement()
                .satisfies(end -> assertThat(end.isNear(GOAL, 1e-9, 1e-9)).isTrue());
        planner.answer();
        RosMessage response = result(answer);
        assertThat(response.integer("status")).isEqualTo(SUCCEEDED);
        RosMessage path = response.message("result").message("path");
        assertThat(path.message("header").text("frame_id")).isEqualTo("map");
        List<Pose2d> poses = path.messages("poses").stream()
                .map(pose -> FrameTransform.of(pose.message("pose"), "position", "orientation")
                        .planar())
                .toList();
        assertThat(poses.getFirst().distanceTo(START)).isCloseTo(0, within(1e-9));
        assertThat(poses.getLast().isNear(GOAL, 1e-9, 1e-9)).isTrue();
        for (int i = 1; i < poses.size(); i++) {
            assertThat(poses.get(i).distanceTo(poses.get(i - 1))).isBetween(0.05, 0.1 + 1e-9);
        }
        double ahead = Math.atan2(GOAL.y() - START.y(), GOAL.x() - START.x());
        assertThat(poses.get(1).theta()).isCloseTo(ahead, within(1e-9));
    }

    @Test
    void lyricalsPlacesOnTheWayAreOnThePath() throws InvalidCdr {
        RosMessage goal = goal(Distribution.LYRICAL, START, GOAL);
        var between = new Pose2d(4, 4, 0);
        CompletableFuture<byte[]> answer = send(
                Distribution.LYRICAL,
                goal.with("viapoints", List.of(StampedPose.of(goal.message("start"), "map", between))));
        planner.answer();
        run.runPending();
        assertThat(planner.ends).hasSize(2);
        planner.answer();
        List<RosMessage> poses =
                result(answer).message("result").message("path").messages("poses");
        assertThat(poses)
                .anySatisfy(pose -> assertThat(FrameTransform.of(pose.message("pose"), "position", "orientation")
                                .planar()
                                .distanceTo(between))
                        .isLessThan(1e-9));
    }

    @ParameterizedTest
    @CsvSource({"GridBased, 0", "other, 1", "planner, 0"})
    void plannersAreChosenByName(String id, int expected) {
        var _ = send(goal(Distribution.JAZZY, START, GOAL).with("planner_id", id));
        assertThat((expected == 0 ? planner : other).starts).hasSize(1);
        assertThat((expected == 0 ? other : planner).starts).isEmpty();
    }

    @Test
    void goalsThatCantBePlannedAreAbortedWithTheErrorsOfNav2() throws InvalidCdr {
        RosMessage goal = goal(Distribution.JAZZY, START, GOAL);
        assertFails(goal.with("planner_id", "Smac"), 201);
        assertFails(goal.with("goal", StampedPose.of(goal.message("goal"), "odom", GOAL)), 202);
        assertFails(goal.with("use_start", false), 202); // it has no localizer
        assertFails(goal.with("goal", StampedPose.of(goal.message("goal"), "map", new Pose2d(Double.NaN, 0, 0))), 202);
    }

    /// Ours tell why in words; the map tells which error of Nav2 it is.
    @ParameterizedTest
    @CsvSource({"-5, 3, 1, 1, 203", "1, 1, -5, 3, 204", "0.01, 0.01, 1, 1, 205", "1, 1, 0.01, 0.01, 206"})
    void noPathHasAReason(double startX, double startY, double x, double y, int code) throws InvalidCdr {
        CompletableFuture<byte[]> answer =
                send(goal(Distribution.JAZZY, new Pose2d(startX, startY, 0), new Pose2d(x, y, 0)));
        planner.answers.getLast().complete(new Planner.Result.NoPath("so it is"));
        RosMessage response = result(answer);
        assertThat(response.integer("status")).isEqualTo(ABORTED);
        assertThat(response.message("result").integer("error_code")).isEqualTo(code);
        assertThat(response.message("result").text("error_msg")).isEqualTo("so it is");
    }

    @Test
    void aPlannerThatFailsOrNeverAnswersIsAnError() throws InvalidCdr {
        CompletableFuture<byte[]> failed = send(goal(Distribution.JAZZY, START, GOAL));
        planner.answers.getLast().completeExceptionally(new IllegalStateException("broken"));
        assertThat(result(failed).message("result").integer("error_code")).isEqualTo(200);
        CompletableFuture<byte[]> silent = send(goal(Distribution.JAZZY, START, GOAL));
        advance(9);
        assertThat(silent).isNotCompleted();
        advance(1);
        assertThat(result(silent).message("result").integer("error_code")).isEqualTo(207);
    }

    @Test
    void aGoalThatIsCanceledEndsAtOnceAndDisturbsNoOther() throws InvalidCdr {
        CompletableFuture<byte[]> first = send(goal(Distribution.JAZZY, START, GOAL));
        CompletableFuture<byte[]> second = send(goal(Distribution.JAZZY, START, GOAL));
        planner.answer();
        assertThat(result(second).integer("status")).isEqualTo(SUCCEEDED);
        goals = 1;
        there.client(ACTION + "cancel_goal", "action_msgs/srv/CancelGoal")
                .call(new CdrWriter().int8s(id()).int32(0).int32(0).toBytes());
        assertThat(result(first).integer("status")).isEqualTo(CANCELED);
        planner.answers.getFirst().complete(new Planner.Result.NoPath("too late"));
        assertThat(result(first).integer("status")).isEqualTo(CANCELED);
    }

    /// As agents ask what hundreds of ways cost.
    @Test
    void resultsOfOldGoalsMakeRoomForNewOnes() throws InvalidCdr {
        for (int i = 0; i < 300; i++) {
            CompletableFuture<byte[]> answer = send(goal(Distribution.JAZZY, START, GOAL));
            planner.answer();
            run.runPending();
            assertThat(answer).isCompleted();
        }
        for (int i = 0; i < 150; i++) {
            var _ = send(goal(Distribution.JAZZY, START, GOAL)); // without an answer
        }
        assertThat(planner.answers).hasSize(400);
    }

    @Test
    void damagedGoalsHarmNobody() throws InvalidCdr {
        RandomGenerator random = new SplittableRandom(1);
        TypeLibrary types = TypeLibrary.of(Distribution.LYRICAL);
        CdrWriter good = new CdrWriter().int8s(new byte[16]);
        MessageCodec.of(types.get(TYPE + "_Goal"), types).write(goal(Distribution.LYRICAL, START, GOAL), good);
        for (int i = 0; i < 5_000; i++) {
            byte[] bytes = good.toBytes().clone();
            for (int flips = random.nextInt(1, 5); flips > 0; flips--) {
                bytes[random.nextInt(4, bytes.length)] = (byte) random.nextInt();
            }
            there.client(ACTION + "send_goal", TYPE + "_SendGoal").call(bytes);
            run.runPending();
            planner.answers.forEach(answer -> answer.complete(new Planner.Result.NoPath("no")));
        }
        goals = 7;
        CompletableFuture<byte[]> answer = send(goal(Distribution.JAZZY, START, GOAL));
        planner.answer();
        assertThat(result(answer).integer("status")).isEqualTo(SUCCEEDED);
    }

    @Test
    void itsNodeIsActiveAsThatOfNav2() throws Exception {
        assertThat(network.nodes()).contains("/r1/planner_server");
        assertThat(bridge.offers())
                .anySatisfy(offer -> assertThat(offer.toString()).contains("compute_path_to_pose"));
        bridge.leave("r1");
        assertThat(network.nodes()).isEmpty();
    }
}
