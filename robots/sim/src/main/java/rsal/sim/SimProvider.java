package rsal.sim;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.atomic.AtomicReference;
import org.jspecify.annotations.Nullable;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.scene.SolidRaster;
import rsal.settings.Parameter;
import rsal.sim.world.RasterWalls;
import rsal.sim.world.World;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.system.RobotSystemProvider.InvalidRobots.Problem;
import rsal.time.Scheduler;

/// Makes simulated worlds. All that they do follows from their configuration and seed.
public final class SimProvider implements RobotSystemProvider {
    static final String KEY = "sim";

    private static final Parameter<Double> STEP = Parameter.number(
            "step", 0.1, 0.01, 0.2, "s", "Time between two states of the world; sensors do not measure more often.");
    static final Parameter<Double> WATCHDOG =
            Parameter.number("watchdog", 0.5, 0.1, 10, "s", "A base stops after this time without a command.");
    static final Parameter<Double> ODOMETRY_NOISE = Parameter.number(
            "odometryNoise",
            1,
            0,
            10,
            "",
            "Factor on the odometry noise of the model: 1 is the noise of the model, 0 is none.");
    static final Parameter<Double> SENSOR_NOISE = Parameter.number(
            "sensorNoise", 1, 0, 10, "", "Factor on the noise of ranges: 1 is the noise of the model, 0 is none.");

    private final AtomicReference<@Nullable Measured> last = new AtomicReference<>();

    /// Walls with their distances, which take a while to measure: a world that is checked and then run, or
    /// run again, needs them once.
    private record Measured(List<SolidRaster> rasters, List<RasterWalls> walls) {}

    @Override
    public String key() {
        return KEY;
    }

    @Override
    public String description() {
        return "Simulates robots and their world inside the run.";
    }

    @Override
    public boolean followsSchedulerTime() {
        return true;
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(STEP, WATCHDOG, ODOMETRY_NOISE, SENSOR_NOISE);
    }

    @Override
    public RobotSystem create(Config config, Scheduler scheduler) {
        var specs = new ArrayList<>(config.robots());
        specs.sort(Comparator.comparing(RobotSpec::id));
        refuse(problems(specs));
        var seeds = new RandomStreams(config.seed());
        var placement = new SpawnPlacement(config.scene(), walls(config.scene().walls()), specs, seeds);
        refuse(placement.problems());
        var assembly = new RobotFactory(config.settings(), scheduler, seeds, placement.world(), placement.things());
        var robots = specs.stream()
                .map(spec -> assembly.robot(spec, placement.body(spec.id())))
                .toList();
        robots.forEach(
                robot -> Optional.ofNullable(config.scene().odomFromBase().get(robot.id()))
                        .ifPresent(robot.drive()::resetOdometry));
        var kinds = robots.stream().map(robot -> kind(robot, config.scene())).toList();
        return new SimSystem(
                scheduler,
                config.settings().seconds(STEP),
                placement.world(),
                config.scene().touch(),
                placement.things(),
                robots,
                new RobotSpawner(placement.world(), assembly, kinds));
    }

    private static RobotSpawner.Kind kind(SimRobot robot, Scene scene) {
        return new RobotSpawner.Kind(
                robot.spec(),
                SpawnPlacement.blocks(scene, robot.spec()),
                robot.body().height(),
                scene.odomFromBase().containsKey(robot.id()));
    }

    private List<RasterWalls> walls(List<SolidRaster> rasters) {
        Measured known = last.get();
        if (known == null || !known.rasters.equals(rasters)) {
            known = new Measured(rasters, rasters.stream().map(RasterWalls::new).toList());
            last.set(known);
        }
        return known.walls;
    }

    private static void refuse(List<Problem> problems) {
        if (!problems.isEmpty()) {
            throw new InvalidRobots(problems);
        }
    }

    private static List<Problem> problems(List<RobotSpec> specs) {
        var problems = new ArrayList<Problem>();
        var ids = new LinkedHashSet<String>();
        for (RobotSpec spec : specs) {
            if (!ids.add(spec.id())) {
                problems.add(new Problem(spec.id(), "id", "Two robots have this id; ids must differ."));
            }
            if (spec.id().equals(World.WALL)) {
                problems.add(new Problem(
                        spec.id(),
                        "id",
                        "The world has an object '%s', which reports could not distinguish from a robot of this id. Maybe '%s-1' is meant."
                                .formatted(World.WALL, spec.role())));
            }
            for (String message : RobotFactory.problems(spec.model())) {
                problems.add(new Problem(spec.id(), "model", message));
            }
        }
        return problems;
    }
}
