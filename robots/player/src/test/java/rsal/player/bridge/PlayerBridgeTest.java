package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.List;
import java.util.Map;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.TimeUnit;
import java.util.function.BooleanSupplier;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.player.client.Connection;
import rsal.player.message.Blobfinder;
import rsal.player.message.Bumper;
import rsal.player.message.Fiducial;
import rsal.player.message.Gripper;
import rsal.player.message.Interface;
import rsal.player.message.Laser;
import rsal.player.message.Pose;
import rsal.player.message.Position2d;
import rsal.player.message.Power;
import rsal.player.message.Ranger;
import rsal.player.message.Sonar;
import rsal.player.wire.Address;
import rsal.player.wire.Kind;
import rsal.player.wire.Packet;
import rsal.sim.SimProvider;
import rsal.system.Bridge.Offer;
import rsal.system.BridgeProvider.Lent;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.contract.RobotBench;

/// A simulated robot as a Player client sees it, over a socket.
@Timeout(60)
class PlayerBridgeTest extends RobotBench {
    private static final Address BASE = Address.of(Interface.POSITION2D.code(), 0);

    private final Map<Integer, Packet> newest = new ConcurrentHashMap<>(); // by interface
    private PlayerBridge bridge;
    private Connection client;

    @Override
    protected RobotSystemProvider provider() {
        return new SimProvider();
    }

    @Override
    protected Map<String, Object> settings() {
        return Map.of("odometryNoise", 0.0);
    }

    @Override
    protected Map<String, String> parts() {
        return Map.of(
                "camera", "blob-camera",
                "gripper", "pioneer-gripper",
                "battery", "small-battery",
                "bumper", "pioneer2dx-bumpers",
                "fiducials", "fiducials360");
    }

    @BeforeEach
    void open() throws IOException {
        bridge = PlayerBridge.open(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                new Lent(List.of(robot()), WORLD.grid(), system().simulation()),
                run);
        client = Connection.open(
                new InetSocketAddress(
                        InetAddress.getLoopbackAddress(),
                        bridge.offers().getFirst().port()),
                Duration.ofSeconds(5),
                packet -> newest.put(packet.header().address().interf(), packet));
    }

    @AfterEach
    void close() {
        client.close();
        bridge.close();
    }

    /// Lets simulated time pass until something is so.
    private void until(BooleanSupplier isSo) throws InterruptedException {
        for (int step = 0; step < 3000 && !isSo.getAsBoolean(); step++) {
            run.advance(STEP);
            TimeUnit.MILLISECONDS.sleep(2); // for the network
        }
        assertThat(isSo.getAsBoolean()).isTrue();
    }

    private <T> T answer(CompletionStage<T> stage) throws InterruptedException {
        var future = stage.toCompletableFuture();
        until(future::isDone);
        return future.join();
    }

    private void subscribe(Interface interf) throws InterruptedException {
        answer(client.subscribe(Address.of(interf.code(), 0)));
        until(() -> newest.containsKey(interf.code()));
    }

    private <T extends Record> T told(Interface interf, Class<T> type) throws IOException, InterruptedException {
        if (!newest.containsKey(interf.code())) {
            subscribe(interf);
        }
        return newest.get(interf.code()).body(type);
    }

    private <T extends Record> T asked(Interface interf, int subtype, Class<T> type)
            throws IOException, InterruptedException {
        Packet request = Packet.of(Address.of(interf.code(), 0), Kind.REQUEST, subtype, 0);
        return answer(client.ask(request)).body(type);
    }

    private void command(int subtype, Record body) {
        client.command(Packet.of(BASE, Kind.COMMAND, subtype, 0, body));
    }

    private PlayerBridge both(RobotSystem two, int port) throws IOException {
        return PlayerBridge.open(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
                new Lent(await(two.discover()), WORLD.grid(), two.simulation()),
                run);
    }

    private RobotSystem two() {
        return create(List.of(spec("r1", START), spec("r2", WORLD.pose('a', 0))), 7);
    }

    @Test
    void eachRobotIsAtAPortOfItsOwnWithItsDevicesCountedFrom0() throws IOException {
        try (RobotSystem two = two();
                PlayerBridge both = both(two, 0)) {
            var bases = both.offers().stream()
                    .filter(offer -> offer.name().startsWith("position2d"))
                    .toList();
            assertThat(bases).extracting(Offer::name).containsExactly("position2d:0", "position2d:0");
            assertThat(bases).extracting(Offer::device).containsExactly("r1/base", "r2/base");
            assertThat(bases).extracting(Offer::port).doesNotHaveDuplicates();
        }
    }

    @Test
    void aPortThatIsTakenIsToldAndTheOthersAreLetGo() throws IOException {
        try (RobotSystem two = two();
                var second = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            int first = second.getLocalPort() - 1;
            assertThatThrownBy(() -> both(two, first))
                    .isInstanceOf(IOException.class)
                    .hasMessageStartingWith("Nobody may listen at (")
                    .hasMessageContaining(Integer.toString(first + 1));
            new ServerSocket(first, 1, InetAddress.getLoopbackAddress()).close();
            assertThatThrownBy(() -> both(two, 65_535)).hasMessageContaining("There is no port (65536) for robot 2");
        }
    }

    @Test
    void allOfItsDevicesAreListed() throws InterruptedException {
        assertThat(answer(client.devices()))
                .extracting(Address::interf)
                .containsExactlyInAnyOrder(
                        Interface.POSITION2D.code(),
                        Interface.RANGER.code(), // laser
                        Interface.RANGER.code(), // sonars
                        Interface.LASER.code(),
                        Interface.SONAR.code(),
                        Interface.BLOBFINDER.code(),
                        Interface.GRIPPER.code(),
                        Interface.POWER.code(),
                        Interface.BUMPER.code(),
                        Interface.FIDUCIAL.code());
        assertThat(answer(client.driver(BASE))).isEqualTo("sim");
    }

    @Test
    void drivesAsToldUntilTheClientIsGone() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0.3, 0, 0), 1));
        until(() -> truth().x() > START.x() + 2); // said once
        var state = told(Interface.POSITION2D, Position2d.State.class);
        assertThat(state.velocity().x()).isCloseTo(0.3, within(0.01));
        assertThat(state.stall()).isZero();
        assertThat(state.odomFromBase().x()).isBetween(1.5, 2.5);
        client.close();
        var base = robot().require(DriveBase.class);
        until(() -> base.latest().orElseThrow().value().velocity().speed() == 0);
    }

    @Test
    void velocitiesThatAreNoNumbersAreLeftOut() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(Double.NaN, 0, 0), 1));
        command(Position2d.CAR, new Position2d.Car(0.3, 0)); // not offered
        advance(2);
        answer(client.devices()); // whatever came before it has been read
        advance(1);
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void odometryIsSetAndMotorsAreSwitched() throws Exception {
        subscribe(Interface.POSITION2D);
        var set = new Position2d.Odometry(new Pose(3, 4, 1));
        answer(client.ask(Packet.of(BASE, Kind.REQUEST, Position2d.SET_ODOMETRY, 0, set)));
        until(() -> robot().require(DriveBase.class)
                .latest()
                .orElseThrow()
                .value()
                .odomFromBase()
                .isNear(new Pose2d(3, 4, 1), 1e-9, 1e-9));
        answer(client.ask(Packet.of(BASE, Kind.REQUEST, Position2d.MOTORS, 0, new Position2d.Motors(0))));
        assertThat(robot().require(DriveBase.class).enabled()).isFalse();
        answer(client.ask(Packet.of(BASE, Kind.REQUEST, Position2d.RESET_ODOMETRY, 0)));
        advance(0.2);
        assertThat(robot().require(DriveBase.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .odomFromBase())
                .isEqualTo(Pose2d.ORIGIN);
        var geometry = asked(Interface.POSITION2D, Position2d.GEOMETRY, Position2d.Geometry.class);
        assertThat(geometry.size().length()).isCloseTo(0.44, within(0.05));
        assertThat(geometry.size().width()).isCloseTo(0.38, within(0.05));
    }

    @Test
    void rangesAreThoseOfTheRobot() throws Exception {
        var scan = told(Interface.LASER, Laser.Scan.class);
        LaserScan own =
                robot().require(LaserScanner.class).latest().orElseThrow().value();
        assertThat(scan.ranges()).hasSize(own.count());
        assertThat(scan.minAngle()).isCloseTo((float) own.angleMin(), within(1e-6f));
        assertThat(scan.resolution()).isCloseTo((float) own.angleIncrement(), within(1e-6f));
        assertThat(scan.maxRange()).isCloseTo((float) own.rangeMax(), within(1e-6f));
        for (float range : scan.ranges()) {
            assertThat(range).isBetween(0f, scan.maxRange());
        }
        assertThat(told(Interface.RANGER, Ranger.Ranges.class).ranges()).hasSize(own.count());
        var config = asked(Interface.RANGER, Ranger.CONFIGURATION, Ranger.Configuration.class);
        assertThat(config.maxAngle() - config.minAngle())
                .isCloseTo(config.resolution() * (own.count() - 1), within(1e-9));
        assertThat(asked(Interface.RANGER, Ranger.GEOMETRY, Ranger.Geometry.class)
                        .poses())
                .hasSize(1);
        assertThat(asked(Interface.LASER, Laser.GEOMETRY, Laser.Geometry.class)
                        .pose()
                        .x())
                .isEqualTo(own.baseFromLaser().x());
        int sonars = asked(Interface.SONAR, Sonar.GEOMETRY, Sonar.Geometry.class)
                .poses()
                .size();
        assertThat(told(Interface.SONAR, Sonar.Ranges.class).ranges()).hasSize(sonars);
    }

    @Test
    void theOthersTellWhatTheyFeelAndSee() throws Exception {
        var power = told(Interface.POWER, Power.State.class);
        assertThat(power.valid() & Power.PERCENT).isNotZero();
        assertThat(power.percent()).isBetween(90f, 100f);
        var bumpers = told(Interface.BUMPER, Bumper.State.class);
        assertThat(asked(Interface.BUMPER, Bumper.GEOMETRY, Bumper.Geometry.class)
                        .bumpers())
                .hasSameSizeAs(bumpers.pressed());
        assertThat(told(Interface.BLOBFINDER, Blobfinder.Blobs.class).blobs()).isEmpty();
        assertThat(told(Interface.FIDUCIAL, Fiducial.Markers.class).markers()).isEmpty();
    }

    @Test
    void aGripperClosesAndOpens() throws Exception {
        subscribe(Interface.GRIPPER);
        assertThat(told(Interface.GRIPPER, Gripper.State.class).state()).isEqualTo(1);
        client.command(Packet.of(Address.of(Interface.GRIPPER.code(), 0), Kind.COMMAND, Gripper.CLOSE, 0));
        until(() -> gripper() == 2);
        client.command(Packet.of(Address.of(Interface.GRIPPER.code(), 0), Kind.COMMAND, Gripper.OPEN, 0));
        until(() -> gripper() == 1);
    }

    private int gripper() {
        try {
            return told(Interface.GRIPPER, Gripper.State.class).state();
        } catch (IOException | InterruptedException e) {
            throw new AssertionError(e);
        }
    }
}
