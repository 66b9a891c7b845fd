package rsal.bench.place;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import rsal.data.OccupancyGrid;
import rsal.data.Pose2d;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.Scheduler;

/// Simulated Pioneers, and the software devices that they are given.
public final class Pioneers {
    static final FileSource FILES = FileSource.resources(RobotModels.class, "/");

    /// A laser that looks 120° to each side and not behind.
    public static final Map<String, String> LASER = Map.of("laser", "urg04lx");

    private Pioneers() {}

    /// @param sensors parts by where they are mounted
    public static RobotModel model(Map<String, String> sensors) {
        Location here = Location.of("bench");
        var choices = new HashMap<String, RobotModels.Choice>();
        sensors.forEach((mount, part) -> choices.put(mount, new RobotModels.Choice(part, here)));
        return new RobotModels(FILES).read("pioneer2dx", here, choices);
    }

    /// @param floor that they stand on
    /// @param starts where the robots `r0`, `r1` and so on start
    /// @param sensors parts by where they are mounted
    public static RobotSystem open(
            OccupancyGrid floor, List<Pose2d> starts, Map<String, String> sensors, long seed, Scheduler time) {
        RobotModel pioneer = model(sensors);
        var specs = new ArrayList<RobotSpec>();
        for (Pose2d start : starts) {
            specs.add(new RobotSpec("r" + specs.size(), "robot", pioneer, Optional.of(start), "#000000"));
        }
        var simulator = ServiceLoader.load(RobotSystemProvider.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(provider -> provider.key().equals("sim"))
                .findFirst()
                .orElseThrow();
        return simulator.create(
                new RobotSystemProvider.Config(
                        Arguments.defaults(simulator.parameters()), Scene.of(floor), specs, seed),
                time);
    }

    public static DeviceDriver driver(String key) {
        return ServiceLoader.load(DeviceDriver.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(driver -> driver.key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    /// A robot that has a software device more.
    ///
    /// @param map that the device is given
    public static Robot equip(
            Robot robot,
            DeviceDriver driver,
            Map<String, ?> settings,
            OccupancyGrid map,
            Optional<Pose2d> start,
            Scheduler time,
            SplittableRandom random) {
        var context = new DeviceDriver.Context(
                driver.key(), robot, map, start, time, new SplittableRandom(random.nextLong()));
        return robot.with(driver.create(context, Arguments.of(driver.parameters(), settings)));
    }
}
