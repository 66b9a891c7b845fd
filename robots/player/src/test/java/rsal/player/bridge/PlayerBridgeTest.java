package rsal.player.bridge;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.assertj.core.api.Assertions.within;

import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.InflaterInputStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.player.client.Connection;
import rsal.player.client.Delivery;
import rsal.player.message.Actarray;
import rsal.player.message.Blobfinder;
import rsal.player.message.Box3;
import rsal.player.message.BumperInterface;
import rsal.player.message.Chars;
import rsal.player.message.Dio;
import rsal.player.message.Fiducial;
import rsal.player.message.GripperInterface;
import rsal.player.message.Interface;
import rsal.player.message.Laser;
import rsal.player.message.MapInterface;
import rsal.player.message.Pose;
import rsal.player.message.Pose3;
import rsal.player.message.Position2d;
import rsal.player.message.Power;
import rsal.player.message.Protocol;
import rsal.player.message.Ranger;
import rsal.player.message.Session;
import rsal.player.message.Simulation;
import rsal.player.message.Sonar;
import rsal.player.message.Version30;
import rsal.player.wire.Address;
import rsal.player.wire.Header;
import rsal.player.wire.MessageKind;
import rsal.player.wire.Packet;
import rsal.robot.Robot;
import rsal.robot.RobotModel.Part;
import rsal.sim.SimProvider;
import rsal.system.BridgeContext;
import rsal.system.ExportedDevice;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;

/// A simulated robot as a Player client sees it, over a socket.
@Timeout(60)
class PlayerBridgeTest extends BridgeBench {
    private static final Pose3 NOWHERE = new Pose3(0, 0, 0, 0, 0, 0);

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

    private PlayerBridge both(RobotSystem two, int port) throws IOException {
        return PlayerBridge.open(
                new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
                new BridgeContext(await(two.discover()), WORLD.grid(), two.simulation(), List.of()),
                Protocol.V3_1,
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
            assertThat(bases).extracting(ExportedDevice::name).containsExactly("position2d:0", "position2d:0");
            assertThat(bases).extracting(ExportedDevice::device).containsExactly("r1/base", "r2/base");
            assertThat(bases).extracting(ExportedDevice::port).doesNotHaveDuplicates();
        }
    }

    @Test
    void aPortThatIsTakenIsReportedAndTheOthersAreLetGo() throws IOException {
        try (RobotSystem two = two();
                var second = takenAfterAFreeOne()) {
            int first = second.getLocalPort() - 1;
            assertThatThrownBy(() -> both(two, first))
                    .isInstanceOf(IOException.class)
                    .hasMessageStartingWith("RSAL can't listen at '")
                    .hasMessageContaining(Integer.toString(first + 1));
            new ServerSocket(first, 1, InetAddress.getLoopbackAddress()).close();
            assertThatThrownBy(() -> both(two, 65_535)).hasMessageContaining("There is no port '65536'");
        }
    }

    /// A port that is taken. Nobody has the one before it, which others than this test may have by chance.
    private static ServerSocket takenAfterAFreeOne() throws IOException {
        while (true) {
            var taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress());
            try {
                new ServerSocket(taken.getLocalPort() - 1, 1, InetAddress.getLoopbackAddress()).close();
                return taken;
            } catch (IOException _) {
                taken.close();
            }
        }
    }

    @Test
    void allOfItsDevicesAreListed() throws InterruptedException {
        assertThat(answer(client().devices()))
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
                        Interface.FIDUCIAL.code(),
                        Interface.SIMULATION.code(),
                        Interface.MAP.code(),
                        Interface.ACTARRAY.code(), // lift
                        Interface.DIO.code());
        assertThat(answer(client().driver(BASE))).isEqualTo("sim");
    }

    @Test
    void drivesAsCommandedUntilTheClientIsGone() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0.3, 0, 0), 1));
        until(() -> truth().x() > START.x() + 2); // said once
        var state = reported(Interface.POSITION2D, Position2d.State.class);
        assertThat(state.velocity().x()).isCloseTo(0.3, within(0.01));
        assertThat(state.stall()).isZero();
        assertThat(state.odomFromBase().x()).isBetween(1.5, 2.5);
        client().close();
        var base = robot().require(DriveBase.class);
        until(() -> base.latest().orElseThrow().value().velocity().speed() == 0);
    }

    @Test
    void velocitiesThatAreNoNumbersAreLeftOut() throws Exception {
        subscribe(Interface.POSITION2D);
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(Double.NaN, 0, 0), 1));
        command(Position2d.GOAL, new Position2d.Goal(new Pose(1, Double.NaN, 0), new Pose(0, 0, 0), 1));
        command(Position2d.VELOCITY_HEADING, new Position2d.VelocityHeading(Double.POSITIVE_INFINITY, 0));
        command(Position2d.CAR, new Position2d.Car(0.3, 0)); // it is none
        advance(2);
        answer(client().devices()); // whatever came before it has been read
        advance(1);
        assertThat(truth()).isEqualTo(START);
    }

    /// What is finite, but can't be reckoned with.
    @ParameterizedTest
    @ValueSource(doubles = {0.8, -2.4, 1e300, Double.MAX_VALUE})
    void standsStillWhereItsWayCanNotBeReckoned(double heading) throws Exception {
        subscribe(Interface.POSITION2D);
        double far = Double.MAX_VALUE;
        ask(Interface.POSITION2D, Position2d.SET_ODOMETRY, new Position2d.Odometry(new Pose(far, far, heading)));
        command(Position2d.GOAL, new Position2d.Goal(new Pose(-far, -far, -far), new Pose(0, 0, 0), 1));
        answer(client().devices()); // the goal has been read
        advance(1);
        command(Position2d.VELOCITY_HEADING, new Position2d.VelocityHeading(0, -1e300));
        answer(client().devices());
        advance(1);
        assertThat(truth().isFinite()).isTrue();
        ask(Interface.POSITION2D, Position2d.SET_ODOMETRY, new Position2d.Odometry(new Pose(0, 0, 0)));
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0.3, 0, 0), 1));
        until(() -> truth().distanceTo(START) > 0.2);
    }

    @Test
    void odometryIsSetAndMotorsAreSwitched() throws Exception {
        subscribe(Interface.POSITION2D);
        var set = new Position2d.Odometry(new Pose(3, 4, 1));
        answer(client().ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.SET_ODOMETRY, 0, set)));
        until(() -> robot().require(DriveBase.class)
                .latest()
                .orElseThrow()
                .value()
                .odomFromBase()
                .isNear(new Pose2d(3, 4, 1), 1e-9, 1e-9));
        answer(client().ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.MOTORS, 0, new Position2d.Motors(0))));
        assertThat(robot().require(DriveBase.class).enabled()).isFalse();
        answer(client().ask(Packet.of(BASE, MessageKind.REQUEST, Position2d.RESET_ODOMETRY, 0)));
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
        var scan = reported(Interface.LASER, Laser.Scan.class);
        LaserScan own =
                robot().require(LaserScanner.class).latest().orElseThrow().value();
        assertThat(scan.ranges()).hasSize(own.count());
        assertThat(scan.minAngle()).isCloseTo((float) own.angleMin(), within(1e-6f));
        assertThat(scan.resolution()).isCloseTo((float) own.angleIncrement(), within(1e-6f));
        assertThat(scan.maxRange()).isCloseTo((float) own.rangeMax(), within(1e-6f));
        for (float range : scan.ranges()) {
            assertThat(range).isBetween(0f, scan.maxRange());
        }
        assertThat(reported(Interface.RANGER, Ranger.Ranges.class).ranges()).hasSize(own.count());
        var config = asked(Interface.RANGER, Ranger.CONFIGURATION, Ranger.Configuration.class);
        assertThat(config.maxAngle() - config.minAngle())
                .isCloseTo(config.resolution() * (own.count() - 1), within(1e-9));
        var shape = asked(Interface.RANGER, Ranger.GEOMETRY, Ranger.Geometry.class);
        assertThat(shape.pose()).isEqualTo(Pose3.of(own.baseFromLaser()));
        assertThat(shape.poses()).as("in its frame").containsExactly(NOWHERE);
        var laser = asked(Interface.LASER, Laser.GEOMETRY, Laser.Geometry.class);
        assertThat(laser.pose()).isEqualTo(Pose3.of(own.baseFromLaser()));
        int sonars = asked(Interface.SONAR, Sonar.GEOMETRY, Sonar.Geometry.class)
                .poses()
                .size();
        assertThat(reported(Interface.SONAR, Sonar.Ranges.class).ranges()).hasSize(sonars);
    }

    /// playerv draws nothing of what has no size.
    @Test
    void whatClientsDrawHasASize() throws Exception {
        advance(0.5); // until all have measured
        var laser = asked(Interface.LASER, Laser.GEOMETRY, Laser.Geometry.class);
        assertThat(laser.size()).isEqualTo(new Box3(0.1, 0.1, 0.1));
        for (int ranger = 0; ranger < 2; ranger++) {
            var shape = answer(client().ask(Packet.of(
                            Address.of(Interface.RANGER.code(), ranger), MessageKind.REQUEST, Ranger.GEOMETRY, 0)))
                    .body(Ranger.Geometry.class);
            assertThat(shape.size().width()).isBetween(0.05, 0.5);
            assertThat(shape.sizes()).hasSameSizeAs(shape.poses()).doesNotContain(new Box3(0, 0, 0));
        }
        var pads = ((Part.Bumper) model().sensors().get("bumper")).pads();
        var bumpers = asked(Interface.BUMPER, BumperInterface.GEOMETRY, BumperInterface.Geometry.class);
        assertThat(bumpers.bumpers()).hasSameSizeAs(pads);
        for (int i = 0; i < pads.size(); i++) {
            assertThat(bumpers.bumpers().get(i).length())
                    .isEqualTo((float) pads.get(i).length())
                    .isPositive();
        }
        var made = (Part.Gripper) model().sensors().get("gripper");
        var gripper = asked(Interface.GRIPPER, GripperInterface.GEOMETRY, GripperInterface.Geometry.class);
        assertThat(gripper.pose()).isEqualTo(Pose3.of(made.baseFromGripper()));
        assertThat(gripper.outer()).isEqualTo(new Box3(made.width(), made.length(), made.height()));
        assertThat(gripper.inner()).isEqualTo(new Box3(made.opening(), made.paddleLength(), made.height()));
    }

    /// A client that always waits for the next step, as Read() of Player's libraries does.
    @Test
    void whatWasMeasuredInOneStepComesInOneRound() throws Exception {
        try (var socket = new Socket(InetAddress.getLoopbackAddress(), port())) {
            socket.setSoTimeout(10_000);
            socket.getInputStream().skipNBytes(Session.IDENT);
            say(socket, Session.MODE, new Session.Mode(Session.PULL));
            for (Interface each : List.of(Interface.POSITION2D, Interface.LASER, Interface.SONAR)) {
                var device = Address.of(each.code(), 0);
                say(socket, Session.DEVICE, new Session.Subscription(device, Session.OPEN, new byte[0]));
            }
            for (int answers = 0; answers < 4; ) {
                until(() -> available(socket));
                answers += next(socket).kind() == MessageKind.ACK ? 1 : 0;
            }
            for (int round = 0; round < 10; round++) {
                socket.getOutputStream()
                        .write(Packet.of(Session.SERVER, MessageKind.REQUEST, Session.DATA, 0)
                                .bytes());
                assertThat(next(socket).kind()).isEqualTo(MessageKind.ACK);
                var reported = new ArrayList<Header>();
                do {
                    until(() -> available(socket));
                    reported.add(next(socket));
                } while (reported.getLast().kind() != MessageKind.SYNCH);
                assertThat(reported.subList(0, reported.size() - 1))
                        .extracting(header -> header.address().interf())
                        .contains(Interface.POSITION2D.code(), Interface.LASER.code(), Interface.SONAR.code());
            }
        }
    }

    private static boolean available(Socket socket) {
        try {
            return socket.getInputStream().available() > 0;
        } catch (IOException e) {
            throw new AssertionError(e);
        }
    }

    private static void say(Socket to, int subtype, Record body) throws IOException {
        to.getOutputStream()
                .write(Packet.of(Session.SERVER, MessageKind.REQUEST, subtype, 0, body)
                        .bytes());
    }

    private static Header next(Socket from) throws IOException {
        return Packet.read(from.getInputStream()).orElseThrow().header();
    }

    @Test
    void theOthersReportWhatTheyFeelAndSee() throws Exception {
        var power = reported(Interface.POWER, Power.State.class);
        assertThat(power.valid() & Power.PERCENT).isNotZero();
        assertThat(power.percent()).isBetween(90f, 100f);
        var bumpers = reported(Interface.BUMPER, BumperInterface.State.class);
        assertThat(asked(Interface.BUMPER, BumperInterface.GEOMETRY, BumperInterface.Geometry.class)
                        .bumpers())
                .hasSameSizeAs(bumpers.pressed());
        assertThat(reported(Interface.BLOBFINDER, Blobfinder.Blobs.class).blobs())
                .isEmpty();
        assertThat(reported(Interface.FIDUCIAL, Fiducial.Markers.class).markers())
                .isEmpty();
    }

    private Pose2d odometry() {
        return robot().require(DriveBase.class).latest().orElseThrow().value().odomFromBase();
    }

    @Test
    void turnsDrivesAndTurnsToAGoalOfItsOdometry() throws Exception {
        var reset = new Position2d.Odometry(new Pose(5, 5, Math.PI / 2));
        ask(Interface.POSITION2D, Position2d.SET_ODOMETRY, reset);
        var goal = new Pose2d(6, 6, -2);
        var reported = new Position2d.Goal(new Pose(goal.x(), goal.y(), goal.theta()), new Pose(0, 0, 0), 1);
        command(Position2d.GOAL, reported);
        until(() -> odometry().isNear(goal, 0.03, Math.toRadians(3)));
        assertThat(truth().x()).isCloseTo(START.x() + 1, within(0.1));
        assertThat(truth().y()).isCloseTo(START.y() - 1, within(0.1));
        advance(2);
        assertThat(odometry().isNear(goal, 0.03, Math.toRadians(3))).isTrue();
        command(Position2d.GOAL, reported);
        until(() -> odometry().isNear(goal, 0.03, Math.toRadians(3)));
        command(Position2d.VELOCITY, new Position2d.Velocity(new Pose(0, 0, 0.5), 1)); // ends it
        until(() -> Math.abs(odometry().theta() - goal.theta()) > 1);
    }

    @Test
    void drivesAlongAHeading() throws Exception {
        command(Position2d.VELOCITY_HEADING, new Position2d.VelocityHeading(0.3, -0.5));
        until(() -> truth().distanceTo(START) > 2);
        assertThat(odometry().theta()).isCloseTo(-0.5, within(0.05));
    }

    @Test
    void aGripperStopsInBetweenAndItsLiftAndBeamsAreOffered() throws Exception {
        subscribe(Interface.GRIPPER);
        client().command(Packet.of(
                Address.of(Interface.GRIPPER.code(), 0), MessageKind.COMMAND, GripperInterface.CLOSE, 0));
        until(() -> gripper() == 3);
        client().command(Packet.of(
                Address.of(Interface.GRIPPER.code(), 0), MessageKind.COMMAND, GripperInterface.STOP, 0));
        answer(client().devices());
        advance(10);
        assertThat(robot().require(rsal.device.Gripper.class)
                        .latest()
                        .orElseThrow()
                        .value()
                        .closed())
                .isStrictlyBetween(0.01, 0.99);
        var up = new Actarray.Position(0, 1);
        client().command(Packet.of(
                Address.of(Interface.ACTARRAY.code(), 0), MessageKind.COMMAND, Actarray.POSITION, 0, up));
        until(() -> lift().position() == 1 && lift().state() == 1);
        var down = new Actarray.Speed(0, -1);
        client().command(Packet.of(
                Address.of(Interface.ACTARRAY.code(), 0), MessageKind.COMMAND, Actarray.SPEED, 0, down));
        until(() -> lift().position() == 0);
        var limits = asked(Interface.ACTARRAY, Actarray.GEOMETRY, Actarray.Geometry.class)
                .joints();
        assertThat(limits).hasSize(1);
        assertThat(limits.getFirst().max()).isEqualTo(1);
        assertThat(reported(Interface.DIO, Dio.Values.class)).isEqualTo(new Dio.Values(4, 0));
    }

    private Actarray.Joint lift() {
        return newest(Interface.ACTARRAY, Actarray.State.class).joints().getFirst();
    }

    @Test
    void aGripperClosesAndOpens() throws Exception {
        subscribe(Interface.GRIPPER);
        assertThat(reported(Interface.GRIPPER, GripperInterface.State.class).state())
                .isEqualTo(1);
        client().command(Packet.of(
                Address.of(Interface.GRIPPER.code(), 0), MessageKind.COMMAND, GripperInterface.CLOSE, 0));
        until(() -> gripper() == 2);
        client().command(Packet.of(
                Address.of(Interface.GRIPPER.code(), 0), MessageKind.COMMAND, GripperInterface.OPEN, 0));
        until(() -> gripper() == 1);
    }

    private int gripper() {
        return newest(Interface.GRIPPER, GripperInterface.State.class).state();
    }

    @Test
    void theTruthIsReportedAndRobotsArePlaced() throws Exception {
        var name = Chars.of("r1");
        var at = ask(Interface.SIMULATION, Simulation.POSE, new Simulation.Placed(name, new Pose(0, 0, 0)))
                .body(Simulation.Placed.class);
        assertThat(Chars.text(at.name())).isEqualTo("r1");
        assertThat(at.pose()).isEqualTo(new Pose(START.x(), START.y(), START.theta()));
        Pose2d a = WORLD.pose('a', 0);
        ask(Interface.SIMULATION, Simulation.SET_POSE, new Simulation.Placed(name, new Pose(a.x(), a.y(), 1)));
        assertThat(truth()).isEqualTo(new Pose2d(a.x(), a.y(), 1));
        var in3d = ask(Interface.SIMULATION, Simulation.POSE3, new Simulation.Placed3(name, NOWHERE, 0))
                .body(Simulation.Placed3.class);
        assertThat(in3d.pose()).isEqualTo(new Pose3(a.x(), a.y(), 0, 0, 0, 1));
        assertThat(in3d.time()).isPositive();
        var start = new Pose3(START.x(), START.y(), 0, 0, 0, 0);
        ask(Interface.SIMULATION, Simulation.SET_POSE3, new Simulation.Placed3(name, start, 0));
        assertThat(truth()).isEqualTo(START);
    }

    @Test
    void whatIsNotThereIsNotPlacedNorAnythingInAWall() throws Exception {
        var nobody = Chars.of("nobody");
        refused(Interface.SIMULATION, Simulation.POSE, new Simulation.Placed(nobody, new Pose(0, 0, 0)));
        refused(Interface.SIMULATION, Simulation.SET_POSE, new Simulation.Placed(nobody, new Pose(1, 1, 0)));
        var outside = new Simulation.Placed(Chars.of("r1"), new Pose(1e300, 0, Double.NaN));
        refused(Interface.SIMULATION, Simulation.SET_POSE, outside);
        Pose2d wall = new Pose2d(0, 0, 0);
        refused(
                Interface.SIMULATION,
                Simulation.SET_POSE,
                new Simulation.Placed(Chars.of("r1"), new Pose(wall.x(), wall.y(), 0)));
        refused(
                Interface.SIMULATION,
                Simulation.PROPERTY,
                new Simulation.Property(Chars.of("r1"), Chars.of("color"), 0, new byte[16]));
        assertThat(truth()).isEqualTo(START);
        var known = new Session.Capability(MessageKind.REQUEST.code(), Simulation.SET_POSE3);
        assertThat(ask(Interface.SIMULATION, 255, known).header().kind()).isEqualTo(MessageKind.ACK);
    }

    @Test
    void theMapComesInTiles() throws Exception {
        var extent = asked(Interface.MAP, MapInterface.INFO, MapInterface.Extent.class);
        OccupancyGrid map = WORLD.grid();
        assertThat(extent)
                .isEqualTo(new MapInterface.Extent(
                        0.25f, map.width(), map.height(), new Pose(map.originX(), map.originY(), 0)));
        int side = 20;
        var seen = new byte[map.width() * map.height()];
        for (int row = 0; row < map.height(); row += side) {
            for (int column = 0; column < map.width(); column += side) {
                MapInterface.Tile tile = tile(column, row, side, side);
                byte[] cells = unpacked(tile.cells(), side * side);
                for (int i = 0; i < cells.length; i++) {
                    int x = column + i % side;
                    int y = row + i / side;
                    if (map.contains(x, y)) {
                        seen[y * map.width() + x] = cells[i];
                    } else {
                        assertThat(cells[i]).isZero();
                    }
                }
            }
        }
        for (int i = 0; i < seen.length; i++) {
            assertThat(seen[i]).isEqualTo((byte) (map.cells()[i] == OccupancyGrid.FREE ? -1 : 1));
        }
    }

    private MapInterface.Tile tile(int column, int row, int width, int height)
            throws IOException, InterruptedException {
        var asked = new MapInterface.Tile(column, row, width, height, 0, 0, new byte[0]);
        return ask(Interface.MAP, MapInterface.TILE, asked).body(MapInterface.Tile.class);
    }

    private static byte[] unpacked(byte[] packed, int size) throws IOException {
        try (var zip = new InflaterInputStream(new ByteArrayInputStream(packed))) {
            byte[] cells = zip.readAllBytes();
            assertThat(cells).hasSize(size);
            return cells;
        }
    }

    /// A client of Player 3.0 is known by what it asks.
    @Test
    void whoAsksForTilesAsPlayer30DoesGetsThemSo() throws Exception {
        var asked = new Version30.Tile(0, 0, 3, 2, new byte[0]);
        Version30.Tile old = ask(Interface.MAP, MapInterface.TILE, asked).body(Version30.Tile.class);
        assertThat(old.width()).isEqualTo(3);
        MapInterface.Tile now = tile(0, 0, 3, 2);
        assertThat(unpacked(old.cells(), 6)).isEqualTo(unpacked(now.cells(), 6));
    }

    @ParameterizedTest
    @CsvSource({"0, 5", "5, 0", "-5, -5", "100000, 100000", "2147483647, 2147483647", "-2147483648, -1"})
    void tilesOfNoSizeOrTooLargeAreRefused(int width, int height) {
        refused(Interface.MAP, MapInterface.TILE, new MapInterface.Tile(0, 0, width, height, 0, 0, new byte[0]));
    }

    @Test
    void tilesFromAnywhereElseAreUnknown() throws Exception {
        MapInterface.Tile tile = tile(Integer.MAX_VALUE - 1, Integer.MIN_VALUE, 3, 3);
        assertThat(unpacked(tile.cells(), 9)).containsOnly(0);
    }

    @ParameterizedTest
    @ValueSource(longs = {1, 2, 3})
    void whoeverBabblesDisturbsNobody(long seed) throws Exception {
        assertBabbleDisturbsNobody(seed, "sim");
    }

    @Test
    void aRobotThatComesLaterHasAPortOfItsOwnAndLosesItWhenItGoes() throws Exception {
        List<String> before = offers().stream().map(ExportedDevice::device).toList();
        Robot second = await(create(List.of(spec("r2", WORLD.pose('b', 0))), 1).discover())
                .getFirst();
        List<ExportedDevice> its = bridge().join(second);
        assertThat(its)
                .extracting(ExportedDevice::device)
                .contains("r2/base", "map")
                .doesNotContain("simulation");
        assertThat(its).extracting(ExportedDevice::port).doesNotContain(port());
        assertThat(bridge().join(second)).as("it is there already").isEmpty();
        assertThat(offers()).containsAll(its).hasSize(before.size() + its.size());
        try (var newcomers = Connection.open(
                new InetSocketAddress(
                        InetAddress.getLoopbackAddress(), its.getFirst().port()),
                Delivery.PULL,
                Duration.ofSeconds(5),
                new ArrayList<Packet>()::add)) {
            assertThat(answer(newcomers.devices())).extracting(Address::interf).contains(BASE.interf());
            bridge().leave("r2");
            assertThat(answer(newcomers.lost())).isNotBlank();
        }
        bridge().leave("r2");
        assertThat(offers()).extracting(ExportedDevice::device).isEqualTo(before);
        assertThat(answer(client().devices())).as("others stay").isNotEmpty();
    }

    @Test
    void aRobotThatNobodyMayListenForIsNotOffered() throws IOException {
        try (var first = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
            int taken = first.getLocalPort();
            var at = new InetSocketAddress(InetAddress.getLoopbackAddress(), taken);
            var context = new BridgeContext(List.of(), WORLD.grid(), Optional.empty(), List.of());
            try (PlayerBridge empty = PlayerBridge.open(at, context, Protocol.V3_1, run)) {
                assertThatThrownBy(() -> empty.join(robot()))
                        .isInstanceOf(IOException.class)
                        .hasMessageStartingWith("RSAL can't listen at 'localhost:" + taken + "':");
                assertThat(empty.offers()).isEmpty();
            }
        }
    }
}
