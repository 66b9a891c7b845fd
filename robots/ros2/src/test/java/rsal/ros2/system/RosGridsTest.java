package rsal.ros2.system;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.logging.Handler;
import java.util.logging.LogRecord;
import java.util.logging.Logger;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.robot.Robot;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.cdr.CdrWriter;
import rsal.ros2.link.Profile;
import rsal.ros2.link.RosEndpoint;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosPublisher.Publication;
import rsal.ros2.link.RosTopic;
import rsal.ros2.message.RosMessages;
import rsal.time.LockstepScheduler;

/// A robot with a map and a costmap, whose updates come in parts.
class RosGridsTest {
    private static final String COSTS = "/r1/global_costmap/costmap";
    private static final String GRID = "nav_msgs/msg/OccupancyGrid";
    private static final String UPDATE = "map_msgs/msg/OccupancyGridUpdate";

    private final LockstepScheduler run = new LockstepScheduler();
    private final MemoryNetwork network = new MemoryNetwork();
    private final RosLink there = network.join();
    private final RosMessages messages = new RosMessages();
    private final List<String> warnings = new ArrayList<>();
    private final Logger log = Logger.getLogger("rsal.ros2.device.PublicGrid");
    private final Handler noting = new Handler() {
        @Override
        public void publish(LogRecord reported) {
            warnings.add(reported.getMessage());
        }

        @Override
        public void flush() {}

        @Override
        public void close() {}
    };
    private Publication odometry;
    private Publication maps;
    private Publication updates;
    private Ros2System system;
    private Robot robot;

    @BeforeEach
    void robotIsThere() {
        log.addHandler(noting);
        odometry = there.advertise(new RosTopic("/r1/odom", "nav_msgs/msg/Odometry"), Profile.DEFAULT);
        there.subscribe(new RosTopic("/r1/cmd_vel", "geometry_msgs/msg/Twist"), Profile.DEFAULT, _ -> {});
        maps = there.advertise(new RosTopic("/r1/map", GRID), Profile.LATCHED);
        updates = there.advertise(new RosTopic("/r1/map_updates", UPDATE), Profile.DEFAULT);
        system = new OneRobot(network, run).system(Map.of("map", "own-map", "navigator", "own-navigator"));
        var found = system.discover().toCompletableFuture();
        advance(3);
        robot = found.join().getFirst();
    }

    @AfterEach
    void close() {
        system.close();
        log.removeHandler(noting);
    }

    private void advance(double seconds) {
        for (int i = 0; i < Math.round(seconds * 20); i++) {
            odometry.publish(messages.odometry(
                    run.instant(), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
            run.advance(Duration.ofMillis(50));
        }
    }

    private void publish(Publication grids, byte... cells) {
        publish(grids, run.instant(), cells);
    }

    private void publish(Publication grids, Instant stamp, byte[] cells) {
        var grid = new OccupancyGrid(cells.length / 2, 2, 0.05, 0, 0, cells);
        grids.publish(messages.map(stamp, grid, "map"));
        advance(0.1);
    }

    private void update(Publication to, Instant stamp, int x, int y, int width, byte... cells) {
        CdrWriter writer = RosMessages.write(new CdrWriter(), stamp).text("map");
        writer.int32(x).int32(y).int32(width).int32(cells.length / Math.max(1, width));
        to.publish(writer.int32(cells.length).int8s(cells).toBytes());
        advance(0.1);
    }

    private byte[] map() {
        return robot.require(Mapper.class).latest().orElseThrow().value().cells();
    }

    @Test
    void updatesChangeTheMapSinceItWasSentWhole() {
        update(updates, run.instant(), 0, 0, 1, (byte) 100);
        assertThat(robot.require(Mapper.class).latest()).isEmpty();
        Instant before = run.instant();
        advance(0.1);
        publish(maps, new byte[6]);
        byte[] first = map();
        update(updates, run.instant(), 1, 0, 2, (byte) 100, (byte) 0, (byte) -1, (byte) 100);
        assertThat(map()).containsExactly(0, 100, 0, 0, -1, 100);
        assertThat(first).containsOnly(0);
        update(updates, before, 0, 0, 1, (byte) 100);
        assertThat(map()).as("the map is newer").containsExactly(0, 100, 0, 0, -1, 100);
        assertThat(warnings).isEmpty();
        publish(maps, new byte[4]);
        assertThat(map()).containsExactly(0, 0, 0, 0);
    }

    /// As when a latched map comes again after the connection was lost, or two messages overtake each other.
    @Test
    void anOlderMapDoesNotUndoAnUpdate() {
        Instant old = run.instant();
        advance(0.1);
        publish(maps, new byte[6]);
        update(updates, run.instant(), 0, 0, 1, (byte) 100);
        publish(maps, old, new byte[6]);
        assertThat(map()).containsExactly(100, 0, 0, 0, 0, 0);
        publish(maps, Instant.EPOCH, new byte[4]); // without a time
        assertThat(map()).containsExactly(0, 0, 0, 0);
        publish(maps, old, new byte[6]);
        assertThat(map()).as("nothing was updated since").hasSize(6);
    }

    /// The map of a simulator that was reset has old stamps.
    @Test
    void anOlderMapIsTakenWhenTheRobotsTimeWentBack() {
        advance(5);
        publish(maps, new byte[6]);
        update(updates, run.instant(), 0, 0, 1, (byte) 100);
        odometry.publish(messages.odometry(
                Instant.ofEpochSecond(1), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
        run.advance(Duration.ofMillis(50));
        publish(maps, Instant.ofEpochSecond(1), new byte[4]);
        assertThat(map()).containsExactly(0, 0, 0, 0);
    }

    /// A latched one comes once, maybe before the odometry that says that time went back.
    @Test
    void aMapThatIsThereBeforeTheTimeWentBackIsTakenThen() {
        advance(5);
        publish(maps, new byte[6]);
        update(updates, run.instant(), 0, 0, 1, (byte) 100);
        var grid = new OccupancyGrid(2, 2, 0.05, 0, 0, new byte[4]);
        maps.publish(messages.map(Instant.ofEpochSecond(1), grid, "map"));
        run.advance(Duration.ofMillis(50));
        assertThat(map()).hasSize(6);
        odometry.publish(messages.odometry(
                Instant.ofEpochSecond(1), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
        run.advance(Duration.ofMillis(100));
        assertThat(map()).containsExactly(0, 0, 0, 0);
    }

    @Test
    void updatesAreTakenAfterTheTimeWentBackThoughTheMapIsOfBefore() {
        advance(5);
        publish(maps, new byte[6]);
        odometry.publish(messages.odometry(
                Instant.ofEpochSecond(1), new Odometry(Pose2d.ORIGIN, Twist2d.STOP, false), "odom", "base_link"));
        run.advance(Duration.ofMillis(50));
        CdrWriter change =
                RosMessages.write(new CdrWriter(), Instant.ofEpochSecond(1)).text("map");
        change.int32(0).int32(0).int32(1).int32(1);
        updates.publish(change.int32(1).int8s(new byte[] {100}).toBytes());
        run.advance(Duration.ofMillis(50));
        assertThat(map()).containsExactly(100, 0, 0, 0, 0, 0);
    }

    /// A clock that is wrong, or a message of anybody.
    @Test
    void anUpdateOfTheFutureDoesNotFreezeTheMap() {
        publish(maps, new byte[6]);
        update(updates, run.instant().plusSeconds(1_000_000), 0, 0, 1, (byte) 100);
        assertThat(map()).containsExactly(100, 0, 0, 0, 0, 0);
        publish(maps, run.instant(), new byte[4]);
        assertThat(map()).containsExactly(0, 0, 0, 0);
        publish(maps, run.instant().plusSeconds(1_000_000), new byte[6]);
        update(updates, run.instant(), 1, 0, 1, (byte) 100);
        assertThat(map()).containsExactly(0, 100, 0, 0, 0, 0);
    }

    @Test
    void updatesThatDoNotFitChangeNothingAndAreReportedOnce() {
        publish(maps, new byte[6]);
        for (int i = 0; i < 5; i++) {
            update(updates, run.instant(), 2, 1, 2, (byte) 100, (byte) 100);
            update(updates, run.instant(), -1, 0, 1, (byte) 100);
        }
        updates.publish(new byte[] {0, 1, 0, 0, 9, 9});
        advance(0.1);
        assertThat(map()).containsOnly(0);
        assertThat(warnings)
                .containsExactly(
                        "An update on '/r1/map_updates' does not fit the map of 3 × 2 cells. It is ignored, as others like it.");
        system.close();
        assertThat(warnings).last().isEqualTo("10 updates on '/r1/map_updates' did not fit the map.");
    }

    private boolean wantsCosts() {
        return there.endpoints().stream()
                .filter(each -> !each.isPublisher())
                .map(RosEndpoint::topic)
                .anyMatch(new RosTopic(COSTS, GRID)::equals);
    }

    @Test
    void costsOfTheNavigatorComeFromTheFirstQuestionOn() {
        Publication grids = there.advertise(new RosTopic(COSTS, GRID), Profile.LATCHED);
        Publication changes = there.advertise(new RosTopic(COSTS + "_updates", UPDATE), Profile.DEFAULT);
        publish(grids, (byte) 0, (byte) 50, (byte) 99, (byte) -1);
        assertThat(wantsCosts()).isFalse();
        Navigator navigator = robot.require(Navigator.class);
        assertThat(navigator.costMap()).isEmpty();
        assertThat(wantsCosts()).isTrue();
        advance(0.1);
        assertThat(navigator.costMap().orElseThrow().cells()).containsExactly(0, 50, 100, -1);
        update(changes, run.instant(), 0, 0, 2, (byte) 12, (byte) 0);
        assertThat(navigator.costMap().orElseThrow().cells()).containsExactly(12, 0, 100, -1);
        advance(0.1);
        update(changes, Instant.EPOCH, 1, 1, 1, (byte) 7); // as Nav2's costmaps: without a time
        assertThat(navigator.costMap().orElseThrow().cells()).containsExactly(12, 0, 100, 7);
        grids.close();
        assertThat(navigator.costMap()).isEmpty();
        system.close();
        assertThat(wantsCosts()).isFalse();
    }
}
