package rsal.ros2.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.within;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.EnumSource;
import rsal.data.Covariance2d;
import rsal.data.OccupancyGrid;
import rsal.data.ParticleCloud;
import rsal.data.Path2d;
import rsal.data.Pose2d;
import rsal.data.PoseEstimate;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DeviceCore;
import rsal.device.DeviceInfo;
import rsal.device.DriveBase;
import rsal.device.GoalHandle;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.SensorCore;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.FrameTransform;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;
import rsal.system.Bridge;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;
import rsal.testkit.fake.FakeNavigator;
import rsal.testkit.fake.FakeProvider;

/// What programs of Nav2 and RViz have of a robot of ours that navigates: goals of several poses, its way, its costs,
/// its particles.
class PublishedNavigationTest extends RobotBench {
    private static final String TYPE = "nav2_msgs/action/NavigateThroughPoses";
    private static final String ACTION = "/r1/navigate_through_poses/_action/";
    private static final TypeLibrary KILTED = TypeLibrary.of(Distribution.KILTED);
    private static final Pose2d BETWEEN = START.compose(new Pose2d(2, 0, 0));
    private static final Pose2d LAST = START.compose(new Pose2d(3.5, 0, 0));
    private static final int SUCCEEDED = 4;
    private static final int CANCELED = 5;
    private static final int ABORTED = 6;

    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final List<RosMessage> feedback = new ArrayList<>();
    private final List<RosMessage> heard = new ArrayList<>();
    private Costly navigator;
    private final Lost localizer = new Lost();
    private Bridge bridge;
    private int goals;

    /// Knows what places cost.
    private static final class Costly extends DeviceCore implements Navigator {
        private final FakeNavigator driving;
        private Optional<OccupancyGrid> costs = Optional.of(new OccupancyGrid(2, 1, 0.5, 1, 2, new byte[] {0, 100}));

        Costly(FakeNavigator driving) {
            super(new DeviceInfo("r1", "navigator", "test"));
            this.driving = driving;
        }

        @Override
        public GoalHandle<Progress, Result> goTo(Pose2d mapFromGoal, Tolerance tolerance) {
            return driving.goTo(mapFromGoal, tolerance);
        }

        @Override
        public void pause() {
            driving.pause();
        }

        @Override
        public void resume() {
            driving.resume();
        }

        @Override
        public boolean paused() {
            return driving.paused();
        }

        @Override
        public Optional<Pose2d> goal() {
            return driving.goal();
        }

        @Override
        public Path2d path() {
            return driving.path();
        }

        @Override
        public Optional<OccupancyGrid> costMap() {
            return costs;
        }
    }

    /// Has two particles.
    private static final class Lost extends SensorCore<PoseEstimate> implements Localizer {
        private Optional<Stamped<ParticleCloud>> cloud = Optional.empty();

        Lost() {
            super(new DeviceInfo("r1", "localizer", "test"));
        }

        void publish(Instant time) {
            cloud = Optional.of(new Stamped<>(
                    time, "map", new ParticleCloud(new float[] {1, 2, 0, 3, 4, 1}, new float[] {0.25f, 0.75f})));
            deliver(new Stamped<>(time, "map", PoseEstimate.of(START, Covariance2d.ofDeviations(1, 1, 1))));
        }

        @Override
        public CompletionStage<Void> relocalize(PoseEstimate belief) {
            return CompletableFuture.completedStage(null);
        }

        @Override
        public Optional<Stamped<ParticleCloud>> particles() {
            return cloud;
        }
    }

    @Override
    protected RobotSystemProvider provider() {
        return new FakeProvider();
    }

    @Override
    protected List<DeviceDriver> drivers() {
        return List.of(new FakeNavigator.Driver());
    }

    @BeforeEach
    void publish() {
        Robot driven = robot();
        navigator = new Costly(driven.require(FakeNavigator.class));
        Robot shown = new Robot(
                driven.id(),
                driven.role(),
                driven.model(),
                driven.marker(),
                List.of(driven.require(DriveBase.class), navigator, localizer));
        bridge = PublishedRobots.publish(List.of(shown), WORLD.grid(), network.join(), run);
        listen(ACTION + "feedback", TYPE + "_FeedbackMessage", Profile.DEFAULT, feedback);
        advance(0.3);
    }

    @AfterEach
    void close() {
        bridge.close();
    }

    private void listen(String topic, String type, Profile profile, List<RosMessage> to) {
        MessageCodec codec = MessageCodec.of(KILTED.get(type), KILTED);
        there.subscribe(new RosTopic(topic, type), profile, bytes -> {
            try {
                to.add(codec.read(CdrReader.of(bytes)));
            } catch (InvalidCdr e) {
                throw new AssertionError(topic, e);
            }
        });
    }

    /// As a client of a distribution writes it.
    private CompletableFuture<byte[]> send(Distribution distribution, String frame, Pose2d... poses) {
        var id = new byte[16];
        id[0] = (byte) ++goals;
        CdrWriter request = new CdrWriter().int8s(id);
        if (distribution.compareTo(Distribution.KILTED) >= 0) {
            request.int32(0).int32(0).text("map");
        }
        request.int32(poses.length);
        for (Pose2d pose : poses) {
            FrameTransform place = FrameTransform.of(pose);
            request.int32(12)
                    .int32(34)
                    .text(frame)
                    .float64(place.x())
                    .float64(place.y())
                    .float64(0);
            request.float64(0)
                    .float64(0)
                    .float64(place.rotation().z())
                    .float64(place.rotation().w());
        }
        there.client(ACTION + "send_goal", TYPE + "_SendGoal")
                .call(request.text("").toBytes());
        run.runPending();
        CompletableFuture<byte[]> result = there.client(ACTION + "get_result", TYPE + "_GetResult")
                .call(new CdrWriter().int8s(id).toBytes())
                .toCompletableFuture();
        run.runPending();
        return result;
    }

    private static RosMessage result(CompletableFuture<byte[]> answer) throws InvalidCdr {
        assertThat(answer).isCompleted();
        return MessageCodec.of(KILTED.get(TYPE + "_GetResult_Response"), KILTED).read(CdrReader.of(answer.join()));
    }

    private static List<Long> statuses(RosMessage message) {
        return message.messages("waypoint_statuses").stream()
                .map(status -> status.integer("waypoint_status"))
                .toList();
    }

    @ParameterizedTest
    @EnumSource
    void itDrivesThroughAllPosesAndGoesOnNearOne(Distribution distribution) throws InvalidCdr {
        CompletableFuture<byte[]> answer = send(distribution, "map", BETWEEN, LAST);
        Optional<Pose2d> passing = Optional.empty(); // where it went on to the last pose
        for (int i = 0; i < 200 && !answer.isDone(); i++) {
            advance(0.1);
            if (passing.isEmpty() && navigator.goal().filter(LAST::equals).isPresent()) {
                passing = Optional.of(truth());
            }
        }
        assertThat(passing)
                .hasValueSatisfying(
                        place -> assertThat(place.distanceTo(BETWEEN)).isBetween(0.6, 0.7));
        RosMessage response = result(answer);
        assertThat(response.integer("status")).isEqualTo(SUCCEEDED);
        assertThat(statuses(response.message("result"))).containsExactly(1L, 1L);
        assertThat(truth().distanceTo(LAST)).isLessThan(0.3);
        RosMessage first = feedback.getFirst().message("feedback");
        RosMessage end = feedback.getLast().message("feedback");
        assertThat(first.integer("number_of_poses_remaining")).isEqualTo(2);
        assertThat(first.number("distance_remaining")).isCloseTo(3.5, within(0.3));
        assertThat(statuses(first)).containsExactly(0L, 0L);
        assertThat(end.integer("number_of_poses_remaining")).isEqualTo(1);
        assertThat(statuses(end)).containsExactly(1L, 0L);
    }

    @Test
    void aPoseThatCantBeReachedEndsItWithTheErrorOfNav2() throws InvalidCdr {
        CompletableFuture<byte[]> answer = send(Distribution.JAZZY, "map", BETWEEN, WORLD.pose('x', 0), LAST);
        advance(10);
        RosMessage response = result(answer);
        assertThat(response.integer("status")).isEqualTo(ABORTED);
        assertThat(response.message("result").integer("error_code")).isEqualTo(208);
        assertThat(statuses(response.message("result"))).containsExactly(1L, 3L, 0L);
        assertThat(robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .velocity())
                .isEqualTo(Twist2d.STOP);
    }

    @Test
    void itCanBeCanceledAndANewGoalTakesItsPlace() throws InvalidCdr {
        CompletableFuture<byte[]> first = send(Distribution.JAZZY, "map", BETWEEN, LAST);
        advance(1);
        CompletableFuture<byte[]> second = send(Distribution.JAZZY, "map", LAST, BETWEEN);
        advance(1);
        assertThat(result(first).integer("status")).isEqualTo(ABORTED);
        there.client(ACTION + "cancel_goal", "action_msgs/srv/CancelGoal")
                .call(new CdrWriter().int8s(new byte[16]).int32(0).int32(0).toBytes());
        advance(0.5);
        assertThat(result(second).integer("status")).isEqualTo(CANCELED);
        assertThat(navigator.goal()).isEmpty();
    }

    @Test
    void whatIsNoRouteIsRefused() throws InvalidCdr {
        List<CompletableFuture<byte[]>> all = List.of(
                send(Distribution.JAZZY, "map"),
                send(Distribution.KILTED, "map"),
                send(Distribution.JAZZY, "odom", LAST),
                send(Distribution.JAZZY, "map", LAST, new Pose2d(Double.NaN, 0, 0)));
        for (CompletableFuture<byte[]> answer : all) {
            assertThat(result(answer).integer("status")).isEqualTo(ABORTED);
            assertThat(result(answer).message("result").text("error_msg")).isNotBlank();
        }
        assertThat(navigator.goal()).isEmpty();
    }

    @Test
    void itsPathIsReportedWhileItDrives() {
        listen("/r1/plan", "nav_msgs/msg/Path", Profile.DEFAULT, heard);
        advance(1);
        assertThat(heard).isEmpty();
        navigator.goTo(LAST);
        advance(3);
        assertThat(heard).hasSizeBetween(4, 7); // twice a second
        List<RosMessage> poses = heard.getFirst().messages("poses");
        assertThat(poses.getLast().message("pose").message("position").number("x"))
                .isCloseTo(LAST.x(), within(1e-9));
        assertThat(heard.getFirst().message("header").text("frame_id")).isEqualTo("map");
        advance(20);
        assertThat(heard.getLast().messages("poses")).as("at its end").isEmpty();
        int reported = heard.size();
        advance(2);
        assertThat(heard).hasSize(reported);
    }

    @Test
    void costsAreReportedWhenTheyChange() {
        advance(2);
        listen("/r1/global_costmap/costmap", "nav_msgs/msg/OccupancyGrid", Profile.LATCHED, heard);
        advance(3);
        assertThat(heard).singleElement().satisfies(grid -> {
            assertThat(grid.get("data", byte[].class)).containsExactly(0, 100);
            assertThat(grid.message("info").integer("width")).isEqualTo(2);
        });
        navigator.costs = Optional.of(new OccupancyGrid(2, 1, 0.5, 1, 2, new byte[] {50, 100}));
        advance(2);
        assertThat(heard).hasSize(2);
    }

    @Test
    void particlesAreReportedWhileSomebodySubscribes() {
        localizer.publish(run.instant());
        advance(1);
        listen("/r1/particle_cloud", "nav2_msgs/msg/ParticleCloud", Profile.SENSOR_DATA, heard);
        advance(1);
        assertThat(heard).isEmpty();
        localizer.publish(run.instant());
        advance(1);
        assertThat(heard).singleElement().satisfies(cloud -> {
            assertThat(cloud.message("header").text("frame_id")).isEqualTo("map");
            assertThat(cloud.messages("particles"))
                    .extracting(particle -> particle.number("weight"))
                    .containsExactly(0.25, 0.75);
        });
    }
}
