package rsal.bench.navigation;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import rsal.data.Footprint;
import rsal.data.LaserScan;
import rsal.data.OccupancyGrid;
import rsal.data.Odometry;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.data.Prism;
import rsal.data.Rgb;
import rsal.data.Shape;
import rsal.data.Solid;
import rsal.data.Stamped;
import rsal.data.Twist2d;
import rsal.device.DriveBase;
import rsal.device.LaserScanner;
import rsal.device.SimulationControl;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.Controller.Motion;
import rsal.navigation.avoid.Controller.Target;
import rsal.navigation.avoid.DriveLimits;
import rsal.navigation.avoid.ObstacleMemory;
import rsal.navigation.avoid.Obstacles;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotModel.RangeNoise;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.LockstepScheduler;
import rsal.time.Phase;

/// One way through a [BarnWorld]: a Jackal that knows from odometry where the goal is, and of the world what its
/// laser sees. It ends within 1 m of the goal, when it touches something, or after 100 s.
final class BarnRun {
    static final Footprint FOOTPRINT = Footprint.box(0.5, 0.43, new Point2d(0, 0));
    static final DriveLimits LIMITS = new DriveLimits(2, 3, 2.5, 8);
    static final double BEAT = 0.05; // s

    /// What avoidance counts on for a command to take effect and the next one to come [s].
    static final double REACTION = 0.1;

    private static final Duration STEP = Duration.ofMillis(25);
    private static final Duration PERIOD = Duration.ofMillis(50);
    private static final double LONGEST = 100; // s
    private static final double ARRIVED = 1; // m
    private static final double VIEW = 8; // m
    private static final String ID = "jackal";

    private final LockstepScheduler time = new LockstepScheduler();
    private final RobotSystem system;
    private final SimulationControl truth;
    private final DriveBase base;
    private final LaserScanner laser;
    private final Controller planner;
    private final Obstacles obstacles = new Obstacles(VIEW);
    private final ObstacleMemory blindSpot = new ObstacleMemory(1.5, Duration.ofSeconds(5));
    private double turnRate;
    private double turned; // changes of the turn rate, summed up [rad/s]
    private double distance;

    /// How it ended.
    ///
    /// @param seconds until then
    /// @param roughness how much the commanded turn rate changes [rad/s²]
    /// @param meters driven
    record Outcome(boolean reached, boolean touched, double seconds, double roughness, double meters) {}

    BarnRun(BarnWorld world, Controller planner, long seed) {
        this.planner = planner;
        var simulator = ServiceLoader.load(RobotSystemProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(provider -> provider.key().equals("sim"))
                .findFirst()
                .orElseThrow();
        var spec = new RobotSpec(ID, "robot", jackal(), Optional.of(BarnWorld.START), "#000000");
        var settings = Arguments.of(simulator.parameters(), Map.of("step", STEP.toMillis() * 1e-3));
        system = simulator.create(
                new RobotSystemProvider.Config(settings, Scene.of(emptyMap()), List.of(spec), seed), time);
        truth = system.simulation().orElseThrow();
        var pieces = world.cylinders().stream()
                .map(c -> Prism.standing(new Shape.Disc(c.middle(), c.radius()), 1))
                .toList();
        var cylinders = SimulationControl.Thing.of(
                        "cylinders", Pose2d.ORIGIN, new Solid(pieces), new Rgb(0x80, 0x80, 0x80))
                .asObstacle(); // one thing, as they touch each other
        if (truth.add(cylinders) instanceof SimulationControl.Placement.Refused(var why)) {
            throw new IllegalArgumentException("World %d: %s".formatted(world.number(), why));
        }
        Robot robot = system.discover().toCompletableFuture().join().getFirst();
        base = robot.require(DriveBase.class);
        laser = robot.require(LaserScanner.class);
        time.every(PERIOD, Phase.DEVICES, this::beat);
    }

    private static OccupancyGrid emptyMap() {
        int side = 60;
        return new OccupancyGrid(side, side, 0.5, -17.25, -7, new byte[side * side]);
    }

    /// A Clearpath Jackal with a Hokuyo laser of 270°.
    private static RobotModel jackal() {
        double increment = Math.toRadians(270) / 719;
        var laser = new Part.Laser(
                "laser",
                new Pose2d(0.12, 0, 0),
                -Math.toRadians(135),
                increment,
                720,
                0.05,
                20,
                RangeNoise.of(0.02),
                PERIOD);
        var drive = new RobotModel.Drive(
                LIMITS.speed(),
                LIMITS.turnRate(),
                LIMITS.acceleration(),
                LIMITS.turnAcceleration(),
                new RobotModel.OdometryNoise(0.02, 0.01, 0.03));
        return new RobotModel("jackal", "Jackal", FOOTPRINT, drive, Map.of("laser", laser));
    }

    private void beat() {
        Optional<Stamped<LaserScan>> scan = laser.latest();
        Optional<Stamped<Odometry>> odometry = base.latest();
        if (scan.isEmpty() || odometry.isEmpty()) {
            return;
        }
        Odometry now = odometry.get().value();
        Pose2d odomFromBase = now.odomFromBase();
        Instant instant = time.instant();
        obstacles.clear();
        obstacles.add(scan.get().value());
        blindSpot.recall(scan.get().value(), odomFromBase, instant, 0, obstacles);
        blindSpot.note(scan.get().value(), obstacles, odomFromBase, instant);
        Point2d odomFromGoal = BarnWorld.START.inverse().transform(BarnWorld.GOAL);
        Target target = Target.at(odomFromBase.inverse().transform(odomFromGoal), false);
        Twist2d command = planner.drive(obstacles, target, new Motion(odomFromBase, now.velocity()));
        turned += Math.abs(command.omega() - turnRate);
        turnRate = command.omega();
        base.command(command);
    }

    Outcome run() {
        try (system) {
            Pose2d at = BarnWorld.START;
            double seconds = 0;
            boolean reached = false;
            boolean touched = false;
            while (!reached && !touched && seconds < LONGEST) {
                time.advance(STEP);
                seconds = time.elapsed().toNanos() * 1e-9;
                Pose2d next = truth.truth(ID).orElseThrow();
                distance += at.distanceTo(next);
                at = next;
                reached = at.position().distanceTo(BarnWorld.GOAL) <= ARRIVED;
                touched = !truth.contacts().isEmpty();
            }
            return new Outcome(reached && !touched, touched, seconds, turned / seconds, distance);
        }
    }
}
