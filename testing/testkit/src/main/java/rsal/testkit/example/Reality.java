package rsal.testkit.example;

import java.time.Duration;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.CompletionStage;
import java.util.function.Consumer;
import java.util.stream.Stream;
import rsal.data.OccupancyGrid;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.device.Health;
import rsal.device.RangeSensor;
import rsal.device.SimulationControl;
import rsal.device.Subscription;
import rsal.robot.Robot;
import rsal.scene.Scene;
import rsal.settings.Parameter;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.testkit.fake.FakeDriveBase;
import rsal.testkit.fake.FakeProvider;
import rsal.testkit.fake.FakeSystem;
import rsal.time.LockstepScheduler;
import rsal.time.Scheduler;

/// Robots that nobody knows the truth about, as real ones are, in a hall without walls: reality is not as the map
/// has it, and fakes look at each wall with each beam.
public class Reality implements RobotSystemProvider {
    private static final Parameter<String> HOST = Parameter.text("host", "localhost", "Where they are.");
    private static final Duration LOOKING = Duration.ofSeconds(3); // for robots
    private static final Parameter<Integer> PORT = Parameter.integer("port", 6665, 1, 65535, "", "Where they listen.");

    @Override
    public String key() {
        return "reality";
    }

    @Override
    public String description() {
        return "Robots that nobody knows the truth about.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(HOST, PORT);
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        boolean planning = scheduler instanceof LockstepScheduler; // one that only checks a plan has its own
        String host = planning ? "" : config.settings().get(HOST);
        if (host.equals("nowhere")) {
            throw new IllegalStateException("Nobody is there.");
        }
        var there = new Config(config.settings(), Scene.of(hall()), config.robots(), config.seed());
        return new Robots((FakeSystem) new FakeProvider().create(there, scheduler), host, scheduler);
    }

    private static OccupancyGrid hall() {
        var cells = new byte[64 * 64];
        Arrays.fill(cells, OccupancyGrid.FREE);
        return new OccupancyGrid(64, 64, 1, -32, -32, cells);
    }

    /// @param host `away` can't be reached, `empty` has no robots, `silent` is never done with looking for
    ///     them, `slow` is after 3 s, `stuck` can't let go of them, `watched` knows where they are, and of
    ///     `late` the last one joins after 3 s, of `late-off` with its motors off, of `blind` the last one
    ///     measures no ranges, of `broken` the last one's base has no connection; all others are fine
    private record Robots(FakeSystem fakes, String host, Scheduler scheduler) implements RobotSystem {
        @Override
        public CompletionStage<List<Robot>> discover() {
            return switch (host) {
                case "away" -> CompletableFuture.failedFuture(new IllegalStateException("Nobody answers."));
                case "empty" -> fakes.discover().thenApply(_ -> List.of());
                case "silent" -> new CompletableFuture<>();
                case "slow" -> slowly();
                case "late", "late-off" -> fakes.discover().thenApply(this::withoutTheLast);
                case "blind" -> fakes.discover().thenApply(Robots::withBlindLast);
                case "broken" -> fakes.discover().thenApply(Robots::withBrokenLast);
                default -> fakes.discover();
            };
        }

        private CompletionStage<List<Robot>> slowly() {
            var found = new CompletableFuture<List<Robot>>();
            scheduler.after(LOOKING, () -> fakes.discover().thenAccept(found::complete));
            return found;
        }

        private static List<Robot> withBlindLast(List<Robot> all) {
            Robot last = all.getLast();
            List<Device> others = last.devices().stream()
                    .filter(device -> !(device instanceof RangeSensor))
                    .toList();
            return Stream.concat(
                            all.stream().limit(all.size() - 1),
                            Stream.of(new Robot(last.id(), last.role(), last.model(), last.marker(), others)))
                    .toList();
        }

        private static List<Robot> withBrokenLast(List<Robot> all) {
            ((FakeDriveBase) all.getLast().require(DriveBase.class)).turn(new Health.Lost("No connection."));
            return all;
        }

        private List<Robot> withoutTheLast(List<Robot> all) {
            Robot last = all.getLast();
            last.require(DriveBase.class).enable(host.equals("late"));
            scheduler.after(LOOKING, () -> fakes.publish(new Change.Appeared(last)));
            return all.subList(0, all.size() - 1);
        }

        @Override
        public boolean admitsLateRobots() {
            return host.startsWith("late");
        }

        @Override
        public Subscription onChange(Consumer<? super Change> listener) {
            return fakes.onChange(listener);
        }

        @Override
        public Optional<SimulationControl> simulation() {
            return Optional.empty();
        }

        @Override
        public Optional<SimulationControl> truth() {
            return host.equals("watched") ? fakes.simulation() : Optional.empty();
        }

        @Override
        public void close() {
            fakes.close();
            if (host.equals("stuck")) {
                throw new IllegalStateException("Nobody lets go.");
            }
        }
    }
}
