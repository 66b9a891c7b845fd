package rsal.player;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.net.InetAddress;
import java.net.InetSocketAddress;
import java.time.Duration;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.concurrent.TimeUnit;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import org.awaitility.Awaitility;
import rsal.device.Navigator.Tolerance;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.player.bridge.PlayerBridgeProvider;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scene.RobotService;
import rsal.settings.Arguments;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.sim.SimProvider;
import rsal.system.Bridge;
import rsal.system.BridgeContext;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.Computers;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;
import rsal.time.Scheduler;

/// The robot system `player` whose servers serve simulated robots, for the tests of its contract: all that the robots
/// sense and are told goes through sockets, but within a hundredth of a simulated second, so that it repeats. Its truth
/// is that of the simulation.
final class OverTheWire implements RobotSystemProvider {
    private static final Duration SETTLING = Duration.ofMillis(10);
    private static final Duration FIRST_STEP = Duration.ofMillis(100);
    private static final Duration PATIENCE = Duration.ofSeconds(20);

    private final RobotSystemProvider player = new PlayerProvider();
    private final RobotSystemProvider sim;
    private final List<DeviceDriver> computers;
    private final Map<String, String> served;

    OverTheWire() {
        this(new SimProvider(), List.of());
    }

    /// @param sim of what simulates the robots that are served
    /// @param computers what these have on board
    OverTheWire(RobotSystemProvider sim, List<DeviceDriver> computers) {
        this(sim, computers, Map.of());
    }

    /// @param served names of the robots' devices, by the interfaces that they are served as: `laser:0`
    OverTheWire(Map<String, String> served) {
        this(new SimProvider(), List.of(), served);
    }

    private OverTheWire(RobotSystemProvider sim, List<DeviceDriver> computers, Map<String, String> served) {
        this.sim = sim;
        this.computers = List.copyOf(computers);
        this.served = Map.copyOf(served);
    }

    @Override
    public String key() {
        return player.key();
    }

    @Override
    public String description() {
        return "Robots of another system, over the wire.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return player.parameters();
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        player.create(config, scheduler).close(); // refuses what it has nothing for
        List<RobotSpec> bare = config.robots().stream().map(Computers::bare).toList();
        var simulated = new Config(Arguments.defaults(sim.parameters()), config.scene(), bare, config.seed());
        return new Wired(config, sim.create(simulated, scheduler), (LockstepScheduler) scheduler);
    }

    private final class Wired implements RobotSystem {
        private final Config config;
        private final RobotSystem simulation;
        private final LockstepScheduler scheduler;
        private final List<AutoCloseable> opened = new ArrayList<>();
        private PlayerSystem remote;

        Wired(Config config, RobotSystem simulation, LockstepScheduler scheduler) {
            this.config = config;
            this.simulation = simulation;
            this.scheduler = scheduler;
        }

        @Override
        public CompletionStage<List<Robot>> discover() {
            try {
                List<Robot> real = simulation.discover().toCompletableFuture().join().stream()
                        .map(robot -> Computers.equipped(robot, computers, config, scheduler))
                        .toList();
                scheduler.advance(FIRST_STEP); // devices offer nothing before they have measured
                Bridge bridge = new PlayerBridgeProvider()
                        .open(
                                new InetSocketAddress(InetAddress.getLoopbackAddress(), 0),
                                new BridgeContext(real, config.scene().map(), simulation.simulation(), services(real)),
                                scheduler);
                opened.add(bridge);
                String servers = config.robots().stream()
                        .map(robot -> "localhost:" + port(bridge, robot.id()))
                        .collect(Collectors.joining(","));
                Map<String, Object> settings =
                        new LinkedHashMap<>(config.settings().asMap());
                settings.put("servers", servers);
                settings.put("armed", true);
                remote = (PlayerSystem) player.create(
                        new Config(
                                Arguments.of(parameters(), settings), config.scene(), config.robots(), config.seed()),
                        scheduler);
                opened.addFirst(remote);
                List<Robot> found = found(remote, scheduler);
                scheduler.every(SETTLING, Phase.OBSERVE, () -> settle(remote));
                return CompletableFuture.completedStage(found);
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /// As the file of a server would have them; none for all there are.
        private List<RobotService> services(List<Robot> real) {
            if (served.isEmpty()) {
                return List.of();
            }
            var services = new ArrayList<RobotService>();
            for (Robot robot : real) {
                services.add(new RobotService(
                        "stage",
                        Location.of("test.cfg"),
                        6665 + services.size(),
                        served.keySet().stream().sorted().toList(),
                        List.of(),
                        Optional.of(robot.id()),
                        served,
                        List.of(),
                        new Tolerance(0.1, 0.1),
                        Optional.empty()));
            }
            return services;
        }

        private static int port(Bridge bridge, String robot) {
            return bridge.offers().stream()
                    .filter(offer -> offer.device().startsWith(robot + "/"))
                    .findFirst()
                    .orElseThrow()
                    .port();
        }

        /// The robots that are found, in real time. What the servers say is taken on this thread, as by a run.
        private static List<Robot> found(PlayerSystem remote, LockstepScheduler scheduler) {
            CompletableFuture<List<Robot>> robots = remote.discover().toCompletableFuture();
            Awaitility.await("robots of Player's servers")
                    .atMost(PATIENCE)
                    .pollInSameThread()
                    .pollDelay(Duration.ZERO)
                    .pollInterval(Duration.ofMillis(1))
                    .until(() -> {
                        scheduler.runPending();
                        return robots.isDone();
                    });
            return robots.join();
        }

        /// Waits in real time until nothing is under way; simulated time stands still.
        private static void settle(PlayerSystem remote) {
            remote.settled()
                    .toCompletableFuture()
                    .orTimeout(PATIENCE.toSeconds(), TimeUnit.SECONDS)
                    .join();
        }

        @Override
        public Subscription onChange(Consumer<? super Change> listener) {
            return remote.onChange(listener);
        }

        @Override
        public Optional<SimulationControl> simulation() {
            return simulation.simulation();
        }

        @Override
        public void close() {
            for (AutoCloseable each : opened) {
                try {
                    each.close();
                } catch (Exception e) {
                    throw new IllegalStateException(e);
                }
            }
            opened.clear();
            simulation.close();
        }
    }
}
