package rsal.navigation.device;

import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.concurrent.Executor;
import java.util.function.Function;
import java.util.random.RandomGenerator;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.device.DriveBase;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.SimulationControl;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.robot.TeamLink;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.sim.SimProvider;
import rsal.system.RobotSystemProvider.Config;
import rsal.time.LockstepScheduler;

/// Simulated robots with software devices, and the clock that drives them.
final class NavigationRun {
    final LockstepScheduler scheduler;
    final SimulationControl simulation;
    final List<Robot> robots = new ArrayList<>();

    private OccupancyGrid map;
    private final RandomGenerator.SplittableGenerator random;
    private final Map<String, Optional<Pose2d>> starts = new LinkedHashMap<>();

    NavigationRun(OccupancyGrid map, long seed, Executor workers, List<RobotSpec> specs) {
        this.map = map;
        this.random = new SplittableRandom(seed);
        this.scheduler = new LockstepScheduler(Instant.EPOCH, workers);
        var provider = new SimProvider();
        var system = provider.create(
                new Config(Arguments.defaults(provider.parameters()), Scene.of(map), specs, seed), scheduler);
        robots.addAll(system.discover().toCompletableFuture().join());
        simulation = system.simulation().orElseThrow();
        specs.forEach(spec -> starts.put(spec.id(), spec.mapFromBase()));
    }

    /// Gives each robot a software device.
    NavigationRun with(DeviceDriver driver, Map<String, ?> settings) {
        return with(driver, settings, _ -> TeamLink.ALONE);
    }

    /// Gives each robot a software device that hears those of others.
    ///
    /// @param links by the robots' ids
    NavigationRun with(DeviceDriver driver, Map<String, ?> settings, Function<String, TeamLink> links) {
        robots.replaceAll(robot -> with(robot, driver, settings, links));
        return this;
    }

    /// Gives some robots a software device that hears those of others.
    NavigationRun withOnly(
            List<String> ids, DeviceDriver driver, Map<String, ?> settings, Function<String, TeamLink> links) {
        robots.replaceAll(robot -> ids.contains(robot.id()) ? with(robot, driver, settings, links) : robot);
        return this;
    }

    private Robot with(Robot robot, DeviceDriver driver, Map<String, ?> settings, Function<String, TeamLink> links) {
        return robot.with(driver.create(
                new DeviceDriver.Context(
                        driver.key(),
                        robot,
                        map,
                        starts.getOrDefault(robot.id(), Optional.empty()),
                        scheduler,
                        random.split(),
                        links.apply(robot.id())),
                Arguments.of(driver.parameters(), settings)));
    }

    /// Robots believe in another map than the real one.
    NavigationRun on(OccupancyGrid believed) {
        map = believed;
        return this;
    }

    /// Robots must find out where they are.
    NavigationRun withoutStarts() {
        starts.clear();
        return this;
    }

    static RobotSpec robot(String id, RobotModel model, Pose2d mapFromBase) {
        return new RobotSpec(id, "robot", model, Optional.of(mapFromBase), "#3366cc");
    }

    /// A Pioneer 2-DX with a URG-04LX laser, or what else is chosen for a device.
    static RobotModel pioneer(String laser) {
        Location here = Location.of("test");
        return new RobotModels(FileSource.resources(NavigationRun.class, "/"))
                .read("pioneer2dx", here, Map.of("laser", new RobotModels.Choice(laser, here)));
    }

    /// A robot model without chosen parts.
    static RobotModel model(String name) {
        return new RobotModels(FileSource.resources(NavigationRun.class, "/"))
                .read(name, Location.of("test"), Map.of());
    }

    Robot robot(String id) {
        return robots.stream().filter(r -> r.id().equals(id)).findFirst().orElseThrow();
    }

    Localizer localizer(String id) {
        return robot(id).require(Localizer.class);
    }

    DriveBase base(String id) {
        return robot(id).require(DriveBase.class);
    }

    Navigator navigator(String id) {
        return robot(id).require(Navigator.class);
    }

    Pose2d truth(String id) {
        return simulation.truth(id).orElseThrow();
    }

    /// How far a localizer is off [m].
    double error(String id) {
        return localizer(id).latest().orElseThrow().value().mapFromBase().distanceTo(truth(id));
    }

    void advance(double seconds) {
        scheduler.advance(Duration.ofNanos(Math.round(seconds * 1e9)));
    }
}
