package rsal.bench;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.ServiceLoader;
import java.util.SplittableRandom;
import java.util.function.Predicate;
import rsal.data.OccupancyGrid;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.map.Maps;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModels;
import rsal.robot.RobotSpec;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider;
import rsal.time.Scheduler;

/// The office floor with simulated Pioneers on it that see by a URG-04LX.
final class Office {
    static final FileSource FILES = FileSource.resources(RobotModels.class, "/");
    static final OccupancyGrid MAP = new Maps(FILES).read("office", Location.of("bench"));

    private Office() {}

    /// @param starts where the robots `r0`, `r1` and so on start
    static RobotSystem open(List<Pose2d> starts, long seed, Scheduler time) {
        return open(starts, Map.of("laser", "urg04lx"), seed, time);
    }

    /// The same with other sensors.
    ///
    /// @param sensors parts by where they are mounted
    static RobotSystem open(List<Pose2d> starts, Map<String, String> sensors, long seed, Scheduler time) {
        Location here = Location.of("bench");
        var choices = new HashMap<String, RobotModels.Choice>();
        sensors.forEach((mount, part) -> choices.put(mount, new RobotModels.Choice(part, here)));
        RobotModel pioneer = new RobotModels(FILES).read("pioneer2dx", here, choices);
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
                new RobotSystemProvider.Config(Arguments.defaults(simulator.parameters()), Scene.of(MAP), specs, seed),
                time);
    }

    /// A random place on the floor that will do, looking anywhere.
    static Pose2d place(SplittableRandom random, Predicate<Point2d> willDo) {
        while (true) {
            var place = new Point2d(random.nextDouble(-31, 31), random.nextDouble(-7.5, 7.5));
            if (willDo.test(place)) {
                return new Pose2d(place.x(), place.y(), random.nextDouble(-Math.PI, Math.PI));
            }
        }
    }

    static DeviceDriver driver(String key) {
        return ServiceLoader.load(DeviceDriver.class).stream()
                .map(ServiceLoader.Provider::get)
                .filter(driver -> driver.key().equals(key))
                .findFirst()
                .orElseThrow();
    }

    /// A robot that has a software device more.
    static Robot equip(
            Robot robot,
            DeviceDriver driver,
            Map<String, ?> settings,
            Optional<Pose2d> start,
            Scheduler time,
            SplittableRandom random) {
        var context = new DeviceDriver.Context(
                driver.key(), robot, MAP, start, time, new SplittableRandom(random.nextLong()));
        return robot.with(driver.create(context, Arguments.of(driver.parameters(), settings)));
    }
}
