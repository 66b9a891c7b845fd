package rsal.ros2.system;

import java.time.Duration;
import java.util.ArrayDeque;
import java.util.Deque;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.ros2.MemoryNetwork;
import rsal.ros2.bridge.PublishedRobots;
import rsal.ros2.link.RosLink;
import rsal.ros2.link.RosNetwork;
import rsal.ros2.setting.GripperSettings;
import rsal.ros2.setting.RosSettings;
import rsal.ros2.setting.Safety;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.sim.SimProvider;
import rsal.system.RealRobots.Waiting;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.Computers;
import rsal.time.LockstepScheduler;
import rsal.time.Scheduler;

/// The robot system `ros2` whose robots are simulated and published by our bridge, on a network in memory and in
/// simulated time, for the tests of its contract. Its truth is that of the simulation.
final class OverRos implements RobotSystemProvider {
    private static final Duration STEP = Duration.ofMillis(50);
    private static final Duration FIRST_STEP = Duration.ofMillis(100);
    private static final Duration WATCHDOG = Duration.ofMillis(500);
    private static final int PATIENCE = 200; // steps

    private final RobotSystemProvider ros = new Ros2Provider();
    private final RobotSystemProvider sim;
    private final List<DeviceDriver> computers;
    private final Joining joining;

    /// How the robot system joins the network of the robots.
    interface Joining {
        RosLink join(MemoryNetwork network, Scheduler scheduler);
    }

    OverRos() {
        this(new SimProvider(), List.of());
    }

    /// @param sim of what simulates the robots
    /// @param computers what these have on board
    OverRos(RobotSystemProvider sim, List<DeviceDriver> computers) {
        this(sim, computers, (network, _) -> network.join());
    }

    OverRos(RobotSystemProvider sim, List<DeviceDriver> computers, Joining joining) {
        this.sim = sim;
        this.computers = List.copyOf(computers);
        this.joining = joining;
    }

    @Override
    public String key() {
        return ros.key();
    }

    @Override
    public String description() {
        return "Robots of another system, over ROS 2.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return ros.parameters();
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        ros.create(config, scheduler).close(); // refuses what it has nothing for
        List<RobotSpec> bare = config.robots().stream().map(Computers::bare).toList();
        var simulated = new Config(Arguments.defaults(sim.parameters()), config.scene(), bare, config.seed());
        return new Published(config, sim.create(simulated, scheduler), (LockstepScheduler) scheduler);
    }

    private final class Published implements RobotSystem {
        private final Config config;
        private final RobotSystem simulation;
        private final LockstepScheduler scheduler;
        private final Deque<AutoCloseable> opened = new ArrayDeque<>();
        private Ros2System remote;

        Published(Config config, RobotSystem simulation, LockstepScheduler scheduler) {
            this.config = config;
            this.simulation = simulation;
            this.scheduler = scheduler;
        }

        @Override
        public CompletionStage<List<Robot>> discover() {
            var network = new MemoryNetwork();
            List<Robot> real = simulation.discover().toCompletableFuture().join().stream()
                    .map(robot -> Computers.equipped(robot, computers, config, scheduler))
                    .toList();
            opened.push(PublishedRobots.publish(real, config.scene().map(), network.join(), scheduler));
            scheduler.advance(FIRST_STEP); // who sensors are is known when they have measured
            Map<RobotSpec, String> namespaces = new LinkedHashMap<>();
            config.robots().forEach(robot -> namespaces.put(robot, RosNetwork.namespace(robot.id())));
            remote = new Ros2System(
                    namespaces,
                    "domain 0",
                    () -> joining.join(network, scheduler),
                    Optional.empty(),
                    new RosSettings(new Safety(WATCHDOG, true, "", ""), GripperSettings.USUAL, List.of(), true, false),
                    Waiting.USUAL,
                    scheduler,
                    new SplittableRandom(1));
            opened.push(remote);
            CompletableFuture<List<Robot>> found = remote.discover().toCompletableFuture();
            for (int i = 0; i < PATIENCE && !found.isDone(); i++) {
                scheduler.advance(STEP);
            }
            return found;
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
            while (!opened.isEmpty()) {
                try {
                    opened.pop().close();
                } catch (Exception e) {
                    throw new IllegalStateException(e);
                }
            }
            simulation.close();
        }
    }
}
