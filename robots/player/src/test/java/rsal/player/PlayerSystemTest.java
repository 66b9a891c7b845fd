package rsal.player;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatExceptionOfType;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.net.ServerSocket;
import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.Callable;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.CopyOnWriteArrayList;
import java.util.concurrent.TimeUnit;
import java.util.function.Predicate;
import java.util.function.Supplier;
import org.awaitility.Awaitility;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Mapper;
import rsal.device.Navigator.Tolerance;
import rsal.device.SimulationControl;
import rsal.device.SimulationControl.Placement;
import rsal.model.RobotModels;
import rsal.player.bridge.PlayerBridgeProvider;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scene.RobotService;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.RobotSystem;
import rsal.system.RobotSystem.Change;
import rsal.system.RobotSystemProvider;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.testkit.contract.RobotBench;
import rsal.time.Task;
import rsal.time.WallScheduler;

/// Robots of servers that live on real time, as real ones do: nothing is shared but sockets.
@Timeout(60)
class PlayerSystemTest {
    private static final RobotSystemProvider PROVIDER = new PlayerProvider();

    private final WallScheduler time = new WallScheduler("ours", Runnable::run, PlayerSystemTest::fail);
    private final WallScheduler theirTime = new WallScheduler("theirs", Runnable::run, PlayerSystemTest::fail);
    private final List<Change> changes = new ArrayList<>(); // of our thread
    private final List<Boolean> switched = new CopyOnWriteArrayList<>(); // motors of the served robot, in order
    private RobotSystem simulation;
    private Bridge bridge;
    private RobotSystem system;

    private static void fail(Throwable error) {
        throw new AssertionError(error);
    }

    private static <T> T on(WallScheduler thread, Callable<T> work) {
        var result = new CompletableFuture<T>();
        thread.execute(() -> {
            try {
                result.complete(work.call());
            } catch (Exception e) {
                result.completeExceptionally(e);
            }
        });
        return await(result);
    }

    private static <T> T await(CompletionStage<T> stage) {
        return stage.toCompletableFuture().orTimeout(20, TimeUnit.SECONDS).join();
    }

    private void until(Supplier<Boolean> isSo) {
        Waiting.until(time, isSo, so -> so);
    }

    private static RobotSpec spec(String id, String model, Map<String, String> parts) {
        Location here = Location.of("test");
        var choices = new LinkedHashMap<String, RobotModels.Choice>();
        parts.forEach((device, part) -> choices.put(device, new RobotModels.Choice(part, here)));
        RobotModel read = new RobotModels(FileSource.resources(RobotBench.class, "/")).read(model, here, choices);
        return new RobotSpec(id, "tested", read, Optional.of(RobotBench.START), "#3366cc");
    }

    private static RobotSpec spec() {
        return spec("r1", "pioneer2dx", Map.of("laser", "urg04lx"));
    }

    @BeforeEach
    void simulate() throws IOException {
        var sim = new SimProvider();
        simulation = sim.create(
                new RobotSystemProvider.Config(
                        Arguments.defaults(sim.parameters()), Scene.of(RobotBench.WORLD.grid()), List.of(spec()), 1),
                theirTime);
        serve(0);
    }

    /// Begins to serve.
    private void serve(int port) {
        serve(port, RobotBench.WORLD.grid());
    }

    private void serve(int port, OccupancyGrid map) {
        bridge = on(
                theirTime,
                () -> new PlayerBridgeProvider()
                        .open(
                                new InetSocketAddress(InetAddress.getLoopbackAddress(), port),
                                new BridgeContext(
                                        simulation.discover().toCompletableFuture().join().stream()
                                                .map(this::watched)
                                                .toList(),
                                        map,
                                        simulation.simulation(),
                                        List.of()),
                                theirTime));
    }

    /// Notes how the motors of its base are switched.
    private Robot watched(Robot robot) {
        List<Device> devices = robot.devices().stream()
                .map(device -> device instanceof DriveBase base ? watched(base) : device)
                .toList();
        return new Robot(robot.id(), robot.role(), robot.model(), robot.marker(), devices);
    }

    private Device watched(DriveBase base) {
        return (DriveBase) Proxy.newProxyInstance(
                DriveBase.class.getClassLoader(), new Class<?>[] {DriveBase.class}, (_, method, arguments) -> {
                    if (method.getName().equals("enable")) {
                        switched.add((Boolean) arguments[0]);
                    }
                    return method.invoke(base, arguments);
                });
    }

    private int port() {
        return bridge.offers().getFirst().port();
    }

    private Pose2d truth() {
        return on(
                theirTime,
                () -> simulation.simulation().orElseThrow().truth("r1").orElseThrow());
    }

    @AfterEach
    void close() {
        if (system != null) {
            on(time, () -> {
                system.close();
                return true;
            });
        }
        on(theirTime, () -> {
            bridge.close();
            simulation.close();
            return true;
        });
        time.close();
        theirTime.close();
    }

    private List<Robot> discover(Map<String, Object> settings, RobotSpec... specs) {
        return await(on(time, () -> {
            system = create(settings, specs);
            system.onChange(changes::add);
            return system.discover();
        }));
    }

    private RobotSystem create(Map<String, Object> settings, RobotSpec... specs) {
        return PROVIDER.create(
                new RobotSystemProvider.Config(
                        Arguments.of(PROVIDER.parameters(), settings),
                        Scene.of(RobotBench.WORLD.grid()),
                        List.of(specs),
                        1),
                time);
    }

    private Map<String, Object> armed() {
        return Map.of("port", port(), "armed", true);
    }

    private void drive(DriveBase base, Twist2d velocity, Duration time) {
        Task driving = this.time.every(Duration.ofMillis(50), () -> base.command(velocity));
        pass(time);
        driving.cancel();
    }

    /// Commands it until it is so, however long that takes on a busy machine.
    private void driveUntil(DriveBase base, Predicate<Pose2d> isThere) {
        Task driving = time.every(Duration.ofMillis(50), () -> base.command(Twist2d.drive(0.4, 0)));
        Awaitility.await("a drive")
                .atMost(Duration.ofSeconds(40))
                .pollInSameThread()
                .pollInterval(Duration.ofMillis(10))
                .until(() -> isThere.test(truth()));
        driving.cancel();
    }

    private void pass(Duration duration) {
        var passed = new CompletableFuture<Boolean>();
        time.after(duration, () -> passed.complete(true));
        await(passed);
    }

    private void untilItStands(Robot robot) {
        until(() -> stands(robot));
    }

    /// As far as it has said.
    private static boolean stands(Robot robot) {
        return robot.require(DriveBase.class)
                .latest()
                .map(odometry -> odometry.value().velocity().equals(Twist2d.STOP))
                .orElse(true);
    }

    @Test
    void drivesARobotThatSharesNothingButSockets() {
        Robot robot = discover(armed(), spec()).getFirst();
        DriveBase base = robot.require(DriveBase.class);
        driveUntil(base, truth -> truth.x() > RobotBench.START.x() + 0.15);
        assertThat(on(
                        time,
                        () -> robot.require(LaserScanner.class)
                                .latest()
                                .orElseThrow()
                                .value()
                                .count()))
                .isEqualTo(682);
        assertThat(robot.devices())
                .extracting(Device::info)
                .allSatisfy(info -> assertThat(info.driver()).isEqualTo("player"));
    }

    @Test
    void nothingMovesBeforeItIsArmed() {
        Robot robot = discover(Map.of("port", port()), spec()).getFirst();
        DriveBase base = robot.require(DriveBase.class);
        assertThat(on(time, base::enabled)).isFalse();
        drive(base, Twist2d.drive(0.4, 0), Duration.ofMillis(500));
        assertThat(truth()).isEqualTo(RobotBench.START);
        on(time, () -> {
            base.enable(true);
            return true;
        });
        driveUntil(base, truth -> !truth.equals(RobotBench.START));
    }

    @Test
    void whoeverCommandsNoMoreHasItStop() {
        Robot robot = discover(armed(), spec()).getFirst();
        driveUntil(robot.require(DriveBase.class), _ -> !on(time, () -> stands(robot)));
        untilItStands(robot);
        Pose2d stood = truth();
        pass(Duration.ofMillis(300));
        assertThat(truth()).isEqualTo(stood);
    }

    @Test
    void aServerThatIsKilledIsLostAndFoundAgain() {
        Robot robot = discover(armed(), spec()).getFirst();
        int port = port();
        DriveBase base = robot.require(DriveBase.class);
        drive(base, Twist2d.drive(0.2, 0), Duration.ofMillis(300));
        on(theirTime, () -> {
            bridge.close();
            return true;
        });
        until(() -> robot.devices().stream().allMatch(device -> device.health() instanceof Health.Lost));
        assertThat(on(time, () -> changes.getLast())).isInstanceOf(Change.Gone.class);
        drive(base, Twist2d.drive(0.4, 0), Duration.ofMillis(300)); // of no use, and harms nothing
        until(() -> changes.size() == 1); // it is gone once
        Pose2d stood = truth();
        serve(port);
        until(() -> robot.devices().stream().allMatch(device -> device.health().isOk()));
        assertThat(on(time, () -> changes.getLast())).isEqualTo(new Change.Appeared(robot));
        assertThat(truth()).as("what was wanted before is forgotten").isEqualTo(stood);
        driveUntil(base, truth -> !truth.equals(stood));
    }

    @Test
    void theMapOfItsServerIsItsOwnAndReadAnew() {
        Robot robot = discover(armed(), spec("r1", "pioneer2dx", Map.of("laser", "urg04lx", "map", "own-map")))
                .getFirst();
        var map = robot.require(Mapper.class);
        OccupancyGrid world = RobotBench.WORLD.grid();
        until(() -> map.latest()
                .map(Stamped::value)
                .filter(read -> same(read, world))
                .isPresent());
        assertThat(on(time, map::isComplete)).isTrue();
        int port = port();
        on(theirTime, () -> {
            bridge.close();
            return true;
        });
        until(() -> map.health() instanceof Health.Lost);
        OccupancyGrid other = large();
        serve(port, other);
        until(() -> map.latest()
                .map(Stamped::value)
                .filter(read -> same(read, other))
                .isPresent());
        assertThat(on(time, map::health).isOk()).isTrue();
    }

    /// As large as the floor of the thesis.
    private static OccupancyGrid large() {
        var random = new SplittableRandom(1);
        var cells = new byte[1259 * 312];
        byte[] values = {OccupancyGrid.FREE, OccupancyGrid.OCCUPIED, OccupancyGrid.UNKNOWN};
        for (int i = 0; i < cells.length; i++) {
            cells[i] = values[random.nextInt(3)];
        }
        return new OccupancyGrid(1259, 312, 0.05, -31.475, -7.8, cells);
    }

    private static boolean same(OccupancyGrid one, OccupancyGrid other) {
        return one.width() == other.width()
                && one.resolution() == other.resolution()
                && one.originX() == other.originX()
                && one.originY() == other.originY()
                && Arrays.equals(one.cells(), other.cells());
    }

    @Test
    void robotsOfOneServerShareItsMap() {
        var parts = Map.of("laser", "urg04lx", "sonar", "none", "map", "own-map");
        RobotSpec first = spec("r1", "pioneer2dx", parts);
        RobotSpec second = spec("r2", "pioneer2dx", parts);
        on(theirTime, () -> {
            bridge.close();
            bridge = open(List.of(
                    service("stage", Map.of("position2d:0", "base", "ranger:0", "laser")),
                    service("stage", Map.of("position2d:1", "base", "ranger:1", "laser")),
                    service("mapfile", Map.of("map:0", RobotService.MAP))));
            return true;
        });
        String server = "localhost:" + port();
        List<Robot> robots = discover(Map.of("servers", server + ", " + server + ":1"), first, second);
        assertThat(robots).hasSize(2);
        until(() -> robots.stream()
                .allMatch(its -> its.require(Mapper.class).latest().isPresent()));
    }

    private static RobotService service(String driver, Map<String, String> sources) {
        return new RobotService(
                driver,
                Location.of("test.cfg"),
                6665,
                List.copyOf(sources.keySet()),
                List.of(),
                Optional.of("r1"),
                sources,
                List.of(),
                Tolerance.DEFAULT,
                Optional.empty());
    }

    private static SimulationControl truthOf(RobotSystem system) {
        return system.truth().orElseThrow();
    }

    private void untilSeenAt(String robot, Pose2d there) {
        until(() -> truthOf(system)
                .truth(robot)
                .filter(seen -> seen.isNear(there, 1e-6, 1e-6))
                .isPresent());
    }

    @Test
    void itsSimulationSaysWhereARobotReallyIsAndPutsItElsewhere() {
        Robot robot = discover(Map.of("port", port(), "armed", true, "simulation", "own"), spec())
                .getFirst();
        assertThat(on(time, () -> system.simulation())).as("is not ours").isEmpty();
        assertThat(on(time, () -> truthOf(system).entities())).containsExactly("r1");
        untilSeenAt("r1", RobotBench.START);
        drive(robot.require(DriveBase.class), Twist2d.drive(0.4, 0), Duration.ofMillis(700));
        untilItStands(robot);
        untilSeenAt("r1", truth());
        Pose2d there = RobotBench.WORLD.pose('b', 90);
        assertThat(on(time, () -> {
                    var placed = truthOf(system).place("r1", there);
                    assertThat(truthOf(system).truth("r1"))
                            .as("nobody has looked there yet")
                            .isEmpty();
                    return placed;
                }))
                .isEqualTo(new Placement.Placed());
        untilSeenAt("r1", there);
        assertThat(truth()).isEqualTo(there);
        assertThat(on(time, () -> truthOf(system).place("r1", RobotBench.WORLD.pose('c', 0))))
                .isEqualTo(new Placement.Placed());
        Pose2d outside = new Pose2d(-50, 0, 0);
        on(time, () -> truthOf(system).place("r1", outside)); // refused there, as what is seen tells
        untilSeenAt("r1", RobotBench.WORLD.pose('c', 0));
        assertThat(on(time, () -> truthOf(system).place("nobody", there))).isInstanceOf(Placement.Refused.class);
        assertThat(on(time, () -> truthOf(system).place("r1", new Pose2d(Double.NaN, 0, 0))))
                .isInstanceOf(Placement.Refused.class);
        assertThat(on(time, () -> truthOf(system).truth("nobody"))).isEmpty();
        assertThat(on(time, () -> truthOf(system).contacts())).isEmpty();
    }

    @Test
    void aSimulationThatIsLostKnowsNothingUntilItIsBack() {
        discover(Map.of("port", port(), "simulation", "localhost:" + port()), spec());
        untilSeenAt("r1", RobotBench.START);
        int port = port();
        on(theirTime, () -> {
            bridge.close();
            return true;
        });
        until(() -> truthOf(system).health() instanceof Health.Lost);
        assertThat(on(time, () -> truthOf(system).truth("r1"))).isEmpty();
        assertThat(on(time, () -> truthOf(system).place("r1", RobotBench.START)))
                .isInstanceOfSatisfying(
                        Placement.Refused.class,
                        refused -> assertThat(refused.why())
                                .startsWith("The simulation at 'localhost:" + port + "' is lost: "));
        serve(port);
        untilSeenAt("r1", RobotBench.START);
    }

    @Test
    void theSimulationMayCallARobotSomethingElse() {
        discover(Map.of("port", port(), "simulation", "own", "names", "r1"), spec("hunter", "pioneer2dx", Map.of()));
        untilSeenAt("hunter", RobotBench.START);
    }

    @Test
    void aServerWithoutASimulationIsNamed() {
        on(theirTime, () -> {
            bridge.close();
            bridge = open(List.of(service("stage", Map.of("position2d:0", "base", "ranger:0", "laser"))));
            return true;
        });
        assertThatThrownBy(() -> discover(
                        Map.of("port", port(), "simulation", "own"),
                        spec("r1", "pioneer2dx", Map.of("laser", "urg04lx", "sonar", "none"))))
                .cause()
                .hasMessage("None of the servers ['localhost:%d'] has a 'simulation'.".formatted(port()));
    }

    /// What a file of a world asks for, of the one robot.
    private Bridge open(List<RobotService> services) throws IOException {
        return new PlayerBridgeProvider()
                .open(
                        new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                        new BridgeContext(
                                simulation.discover().toCompletableFuture().join(),
                                RobotBench.WORLD.grid(),
                                Optional.empty(),
                                services),
                        theirTime);
    }

    @Test
    void withoutAServerItSaysSo() throws IOException {
        int nobody;
        try (var free = new ServerSocket(0)) {
            nobody = free.getLocalPort();
        }
        assertThatThrownBy(() -> discover(Map.of("port", nobody, "wait", 3.0), spec()))
                .cause()
                .hasMessage(
                        "There is no Player server at 'localhost:%d': Connection refused. Start the robot's server; or serve simulated robots: rsal bridge player SCENARIO --no-agents."
                                .formatted(nobody));
    }

    @Test
    void aServerThatLacksADeviceIsNamedWithWhatItHas() {
        assertThatThrownBy(() -> discover(
                        armed(), spec("r1", "pioneer2dx", Map.of("laser", "urg04lx", "camera", "blob-camera"))))
                .cause()
                .hasMessageContaining("Robot 'r1' has no device for its 'camera': 'localhost:" + port() + "' has ")
                .hasMessageContaining("position2d:0");
    }

    @Test
    void robotsMayJoinWhenTheirServersStartLate() {
        int port = port();
        on(theirTime, () -> {
            bridge.close();
            return true;
        });
        assertThat(discover(Map.of("port", port, "armed", true, "wait", 3.0, "late", true), spec()))
                .isEmpty();
        serve(port);
        until(() -> !changes.isEmpty());
        assertThat(on(time, () -> changes.getFirst()))
                .isInstanceOfSatisfying(
                        Change.Appeared.class,
                        change -> assertThat(change.robot().id()).isEqualTo("r1"));
    }

    /// The run switches its motors off as it joins, which must not come after they were on.
    @Test
    void aLateRobotJoinsWithItsMotorsOffWhileTheEmergencyStopHolds() {
        int port = port();
        on(theirTime, () -> {
            bridge.close();
            return true;
        });
        assertThat(discover(Map.of("port", port, "armed", true, "wait", 3.0, "late", true), spec()))
                .isEmpty();
        on(
                time,
                () -> system.onChange(change -> {
                    if (change instanceof Change.Appeared(Robot robot)) {
                        robot.require(DriveBase.class).enable(false);
                    }
                }));
        serve(port);
        until(() -> !switched.isEmpty());
        pass(Duration.ofMillis(500));
        assertThat(switched).isNotEmpty().doesNotContain(true);
    }

    @Test
    void anArmedRobotJoinsWithItsMotorsOn() {
        Robot robot = discover(armed(), spec()).getFirst();
        until(() -> switched.contains(true));
        assertThat(switched).as("off until it joins").isEqualTo(List.of(false, true));
        on(time, () -> {
            robot.require(DriveBase.class).enable(false);
            return true;
        });
        until(() -> switched.contains(false));
    }

    /// Its server may have them on, from somebody before.
    @Test
    void motorsAreOffWhileOthersAreWaitedFor() {
        int port = port();
        on(time, () -> {
            system = create(
                    Map.of("servers", "localhost:%d,localhost:1".formatted(port), "wait", 3.0),
                    spec(),
                    spec("r2", "pioneer2dx", Map.of("laser", "urg04lx")));
            return system.discover();
        });
        until(() -> !switched.isEmpty());
        assertThat(switched).containsOnly(false);
    }

    @Test
    void itMayHaveNoRobots() {
        assertThat(discover(Map.of("servers", "nonsense"))).isEmpty();
    }

    @Test
    void robotsThatCantBeAreRefusedBeforeAnythingStarts() {
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(Map.of("servers", "nonsense"), spec()))
                .withMessageContaining("'nonsense' is not a server.");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() ->
                        create(Map.of("servers", "a:1"), spec(), spec("r2", "pioneer2dx", Map.of("laser", "urg04lx"))))
                .withMessageContaining("As many 'servers' as robots are needed: 2, not 1.");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(
                        Map.of("servers", "a:1,a:1"), spec(), spec("r2", "pioneer2dx", Map.of("laser", "urg04lx"))))
                .withMessageContaining("Robots 'r1' and 'r2' are both at 'a:1'.");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() ->
                        create(Map.of("port", 65535), spec(), spec("r2", "pioneer2dx", Map.of("laser", "urg04lx"))))
                .withMessageContaining("There are fewer than 2 ports from 65535 on.");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(Map.of("simulation", "yes"), spec()))
                .withMessageContaining("'yes' is not a server.");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(Map.of("simulation", "a:1, b:1"), spec()))
                .withMessageContaining("'simulation' must be 'own' or HOST:PORT, not 'a:1, b:1'.");
        for (String part : List.of("own-planner", "own-docking")) {
            assertThatExceptionOfType(InvalidRobots.class)
                    .isThrownBy(
                            () -> create(Map.of("servers", "a:1"), spec("r1", "pioneer2dx", Map.of("device", part))))
                    .withMessageContaining("Player has nothing like its '%s'.".formatted(part));
        }
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(Map.of("simulation", "own", "names", "a, b"), spec()))
                .withMessageContaining("As many 'names' as robots are needed: 1, not 2.");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(Map.of("simulation", "own", "late", true), spec()))
                .withMessageContaining("'late' can't be used with 'simulation'");
        assertThatExceptionOfType(InvalidRobots.class)
                .isThrownBy(() -> create(Map.of(), spec("r1", "pioneer2dx", Map.of("light", "beacon"))))
                .withMessageContaining("'beacon'");
    }
}
