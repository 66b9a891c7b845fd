package rsal.bench.robots;

import java.time.Duration;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.locks.LockSupport;
import java.util.function.Function;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.bench.measurement.Bench;
import rsal.bench.measurement.BenchmarkRequest;
import rsal.bench.measurement.Result;
import rsal.bench.measurement.Stopwatch;
import rsal.bench.robots.Beacon.Mark;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.RangeArray;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.Sensor;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.robot.RobotSpec;
import rsal.scenario.installed.Providers;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.AllowedToReadWallClock;
import rsal.time.WallScheduler;

/// Robots of another process ([Beacons]) over the loopback, whose lasers tell ten times a second; then the same while
/// they are driven as often as they tell.
///
/// Names are `<system>[.scanner].<robots>[.driven].<what>`. What: `found`, how long it takes to find all robots; `cpu`,
/// the share of a core that this process takes; `delay.p50`
/// and `delay.p99`, from when the other process has a reading until a listener here is told of it, which is more than
/// from the socket to the listener; `rate`, readings told per second; `skipped`, readings of which a newer one took the
/// place; `old`, devices whose newest reading is not the last that was told, once all is quiet.
@AllowedToReadWallClock("Benchmarks measure real time.")
public final class RemoteBench implements Bench {
    private static final int ROBOTS = 100;
    private static final Duration WARM = Duration.ofSeconds(20);
    private static final Duration WINDOW = Duration.ofSeconds(10);
    private static final Duration QUIET = Duration.ofSeconds(1);
    private static final int DOMAIN = 93; // of ROS 2, where nobody else should be
    private static final Connection PLAYER = new Connection("player", 0, ports -> Map.of("servers", servers(ports)));
    private static final Connection ROS2 = new Connection("ros2", 7400 + 250 * DOMAIN, _ -> Map.of("domain", DOMAIN));

    private final Connection connection;
    private final Beacon.Kind kind;
    private boolean driven; // of the scheduler's thread

    /// How robots of a system that has a bridge, too, are reached.
    ///
    /// @param system `player`
    /// @param port where the bridge begins; 0 for any
    /// @param settings of the system, by where the robots are
    private record Connection(String system, int port, Function<List<Integer>, Map<String, Object>> settings) {}

    private RemoteBench(Connection connection, Beacon.Kind kind) {
        this.connection = connection;
        this.kind = kind;
    }

    /// Robots of Player servers: a laser of 180 beams and 16 sonars each.
    public static RemoteBench player() {
        return new RemoteBench(PLAYER, Beacon.Kind.PIONEER);
    }

    /// Robots of Player servers: a laser of 360 beams each, and odometry 20 times a second.
    public static RemoteBench scannersOfPlayer() {
        return new RemoteBench(PLAYER, Beacon.Kind.SCANNER);
    }

    /// Robots of ROS 2 as of [#scannersOfPlayer].
    public static RemoteBench scannersOfRos2() {
        return new RemoteBench(ROS2, Beacon.Kind.SCANNER);
    }

    private String name(String what) {
        String system = connection.system + (kind == Beacon.Kind.SCANNER ? ".scanner" : "");
        return "%s.%d.%s".formatted(system, ROBOTS, what);
    }

    private static String servers(List<Integer> ports) {
        return ports.stream().map(port -> "localhost:" + port).collect(Collectors.joining(","));
    }

    @Override
    public List<String> names() {
        List<String> whats = List.of("cpu", "delay.p50", "delay.p99", "rate", "skipped");
        return Stream.of(
                        Stream.of("found"),
                        whats.stream(),
                        whats.stream().map(what -> "driven." + what),
                        Stream.of("old"))
                .flatMap(what -> what)
                .map(this::name)
                .toList();
    }

    @Override
    public void measure(BenchmarkRequest assignment) {
        try (var process = new BeaconProcess(connection.system, connection.port, kind, ROBOTS);
                var time = new WallScheduler("listeners", Runnable::run)) {
            RobotSystem robots = on(time, () -> provider().create(config(process.ports()), time));
            try {
                var watch = new Stopwatch();
                List<Ear> ears = listen(robots, time);
                assignment.report(Result.less(name("found"), "s", watch.wall()));
                measure(process, ears, time, assignment);
            } finally {
                on(time, () -> {
                    robots.close();
                    return true;
                });
            }
        }
    }

    private RobotSystemProvider provider() {
        return Objects.requireNonNull(Providers.byKey(RobotSystemProvider.class, RobotSystemProvider::key)
                .get(connection.system));
    }

    private RobotSystemProvider.Config config(List<Integer> ports) {
        List<RobotSpec> specs = IntStream.range(0, ROBOTS)
                .mapToObj(i -> new RobotSpec("r" + i, "beacon", kind.model(), Optional.empty(), "#000000"))
                .toList();
        var settings = new HashMap<>(connection.settings.apply(ports));
        settings.put("armed", true);
        Arguments arguments = Arguments.of(provider().parameters(), settings);
        var nowhere = Scene.of(new OccupancyGrid(1, 1, 1, 0, 0, new byte[1]));
        return new RobotSystemProvider.Config(arguments, nowhere, specs, 1);
    }

    private List<Ear> listen(RobotSystem robots, WallScheduler time) {
        CompletableFuture<List<Robot>> found = on(time, () -> robots.discover().toCompletableFuture());
        List<Robot> all = found.join();
        return on(time, () -> all.stream().flatMap(this::ears).toList());
    }

    private Stream<Ear> ears(Robot robot) {
        DriveBase base = robot.require(DriveBase.class);
        base.subscribe(_ -> {
            if (driven) {
                base.command(Twist2d.drive(0.1, 0));
            }
        });
        return Stream.concat(
                Stream.of(
                        new Ear(base, Mark::of),
                        new Ear(robot.require(LaserScanner.class), (LaserScan scan) -> Mark.of(scan.ranges()))),
                robot.find(SonarArray.class).stream()
                        .map(sonars -> new Ear(sonars, (RangeArray ranges) -> Mark.of(ranges.ranges()))));
    }

    private void measure(BeaconProcess process, List<Ear> ears, WallScheduler time, BenchmarkRequest assignment) {
        pause(WARM);
        windows(name(""), ears, time, assignment);
        on(time, () -> driven = true);
        windows(name("driven."), ears, time, assignment);
        List<Integer> last = process.quiet();
        pause(QUIET);
        double old = on(
                time,
                () -> IntStream.range(0, ears.size())
                        .mapToDouble(i -> ears.get(i).newest == last.get(i * ROBOTS / ears.size()) ? 0 : 1)
                        .sum());
        assignment.report(Result.less(name("old"), "", old));
    }

    private void windows(String key, List<Ear> ears, WallScheduler time, BenchmarkRequest assignment) {
        int repeats = assignment.repeats();
        double[] cpu = new double[repeats];
        double[] median = new double[repeats];
        double[] late = new double[repeats];
        double[] rate = new double[repeats];
        double[] skipped = new double[repeats];
        for (int i = 0; i < repeats; i++) {
            assignment.reach(key + "windows", i, repeats);
            take(ears, time);
            var watch = new Stopwatch();
            pause(WINDOW);
            cpu[i] = watch.cpu() / watch.wall();
            double seconds = watch.wall();
            List<Heard> heard = take(ears, time);
            double[] delays = heard.stream()
                    .flatMapToDouble(one -> Arrays.stream(one.delays))
                    .sorted()
                    .toArray();
            median[i] = delays[delays.length / 2] * 1e3;
            late[i] = delays[delays.length * 99 / 100] * 1e3;
            rate[i] = delays.length / seconds;
            skipped[i] = heard.stream().mapToInt(Heard::skipped).sum();
        }
        assignment.report(
                Result.less(key + "cpu", "core", cpu),
                Result.less(key + "delay.p50", "ms", median),
                Result.less(key + "delay.p99", "ms", late),
                Result.more(key + "rate", "1/s", rate),
                Result.less(key + "skipped", "", skipped));
    }

    private static List<Heard> take(List<Ear> ears, WallScheduler time) {
        return on(time, () -> ears.stream().map(Ear::take).toList());
    }

    private static <T> T on(WallScheduler time, Supplier<T> work) {
        return CompletableFuture.supplyAsync(work, time).join();
    }

    private static void pause(Duration length) {
        LockSupport.parkNanos(length.toNanos());
    }

    /// What one device has told since somebody asked.
    ///
    /// @param delays [s]
    private record Heard(double[] delays, int skipped) {}

    /// Listens to a device. On the scheduler's thread.
    private static final class Ear {
        private final List<Double> delays = new ArrayList<>();
        private int skipped;
        private int newest = -1;

        <T> Ear(Sensor<T> sensor, Function<T, Mark> read) {
            sensor.subscribe(reading -> hear(read.apply(reading.value())));
        }

        private void hear(Mark mark) {
            delays.add(Beacons.since(mark.at()));
            if (newest >= 0 && newest != mark.number()) {
                skipped += mark.since(newest);
            }
            newest = mark.number();
        }

        Heard take() {
            var heard =
                    new Heard(delays.stream().mapToDouble(Double::doubleValue).toArray(), skipped);
            delays.clear();
            skipped = 0;
            return heard;
        }
    }
}
