package rsal.bench.robots;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.concurrent.Executor;
import rsal.data.Footprint;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.SonarArray;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotSpec;
import rsal.scenario.installed.Providers;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.LockstepScheduler;

/// Simulated robots that wander about: forward where there is room, else turning towards where there is more.
/// Their minds cost next to nothing, so that what is measured is the simulator.
final class WanderingRobots implements AutoCloseable {
    private static final Duration PERIOD = Duration.ofMillis(100); // of a step and of each sensor

    private final LockstepScheduler time;
    private final RobotSystem system;
    private long rays;

    /// What the robots are like.
    record Kind(String label, RobotModel model) {
        /// A Pioneer with a laser of 180 beams over 180° and 8 m.
        static final Kind LASER180 = of("laser180", 0.44, "laser", laser(180, 8));

        /// A Pioneer with 16 sonars of 5 m around it, each one ray.
        static final Kind SONAR16 = of("sonar16", 0.44, "sonar", ring(16, 0.22, 5));

        /// A small robot with 12 infrared sensors of 1 m around it.
        static final Kind IR12 = of("ir12", 0.12, "ir", ring(12, 0.06, 1));

        private static Kind of(String label, double size, String device, Part part) {
            var noise = new RobotModel.OdometryNoise(0.02, 0.02, 0.05);
            var drive = new RobotModel.Drive(1, 2, 1, 4, noise);
            var body = Footprint.box(size, size * 0.86, new Point2d(0, 0));
            return new Kind(label, new RobotModel(label, label, body, drive, Map.of(device, part)));
        }

        static Part.Laser laser(int beams, double reach) {
            double increment = Math.PI / (beams - 1);
            return new Part.Laser(
                    "laser", Pose2d.ORIGIN, -Math.PI / 2, increment, beams, 0, reach, RangeNoise.of(0.01), PERIOD);
        }

        static Part.Sonars ring(int sensors, double radius, double reach) {
            var poses = new ArrayList<Pose2d>();
            for (int i = 0; i < sensors; i++) {
                double angle = 2 * Math.PI * (i + 0.5) / sensors;
                poses.add(new Pose2d(radius * Math.cos(angle), radius * Math.sin(angle), angle));
            }
            return new Part.Sonars("ring", poses, Math.toRadians(1), 0, reach, RangeNoise.of(0.01), PERIOD);
        }
    }

    WanderingRobots(OccupancyGrid map, Kind kind, int count, long seed, Executor workers) {
        time = new LockstepScheduler(Instant.EPOCH, workers);
        var robots = new ArrayList<RobotSpec>();
        for (int i = 0; i < count; i++) {
            robots.add(new RobotSpec("r" + i, "robot", kind.model(), Optional.empty(), "#000000"));
        }
        var simulator = simulator();
        var settings = Arguments.of(simulator.parameters(), Map.of("step", PERIOD.toMillis() * 1e-3));
        system = simulator.create(new RobotSystemProvider.Config(settings, Scene.of(map), robots, seed), time);
        List<Robot> found = system.discover().toCompletableFuture().join();
        found.forEach(this::wander);
    }

    private static RobotSystemProvider simulator() {
        return Objects.requireNonNull(Providers.byKey(RobotSystemProvider.class, RobotSystemProvider::key)
                .get("sim"));
    }

    private void wander(Robot robot) {
        DriveBase base = robot.require(DriveBase.class);
        robot.find(LaserScanner.class)
                .ifPresent(laser -> laser.subscribe(scan -> {
                    float[] ranges = scan.value().ranges();
                    rays += ranges.length;
                    int n = ranges.length;
                    base.command(steer(
                            least(ranges, 0, n / 3), least(ranges, n / 3, 2 * n / 3), least(ranges, 2 * n / 3, n)));
                }));
        robot.find(SonarArray.class)
                .ifPresent(ring -> ring.subscribe(reading -> {
                    float[] ranges = reading.value().ranges();
                    rays += ranges.length;
                    int n = ranges.length;
                    float ahead = Math.min(ranges[0], ranges[n - 1]);
                    base.command(steer(least(ranges, 3 * n / 4, n - 1), ahead, least(ranges, 1, n / 4)));
                }));
    }

    private static Twist2d steer(float right, float ahead, float left) {
        if (ahead > 0.7) {
            return Twist2d.drive(0.4, right < 0.4 ? 0.3 : left < 0.4 ? -0.3 : 0);
        }
        return Twist2d.drive(0, left > right ? 0.8 : -0.8);
    }

    private static float least(float[] ranges, int from, int to) {
        float least = Float.POSITIVE_INFINITY;
        for (int i = from; i < to; i++) {
            least = Math.min(least, ranges[i]);
        }
        return least;
    }

    void advance(double seconds) {
        time.advance(Duration.ofMillis(Math.round(seconds * 1e3)));
    }

    /// Ranges measured so far.
    long rays() {
        return rays;
    }

    /// The sum of all places: equal for equal runs.
    double whereabouts() {
        var truth = system.simulation().orElseThrow();
        double sum = 0;
        for (String entity : truth.entities()) {
            Pose2d pose = truth.truth(entity).orElseThrow();
            sum += pose.x() * 1.1 + pose.y() * 1.3 + pose.theta() * 1.7;
        }
        return sum;
    }

    @Override
    public void close() {
        system.close();
    }
}
