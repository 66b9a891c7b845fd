package rsal.testkit.fake;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import rsal.robot.DeviceDriver;
import rsal.robot.Robot;
import rsal.robot.RobotModel;
import rsal.robot.RobotModel.Part;
import rsal.robot.RobotSpec;
import rsal.settings.Arguments;
import rsal.system.RobotSystemProvider.Config;
import rsal.time.Scheduler;

/// Computers on board of simulated robots that are offered to somebody else. They do what is no
/// hardware, such as localization.
public final class Computers {
    private Computers() {}

    /// A robot without what its own computer does.
    public static RobotSpec bare(RobotSpec spec) {
        RobotModel model = spec.model();
        var hardware = new LinkedHashMap<>(model.sensors());
        hardware.values().removeIf(Part.Own.class::isInstance);
        return new RobotSpec(
                spec.id(),
                spec.role(),
                new RobotModel(
                        model.name(),
                        model.title(),
                        model.body(),
                        model.drive(),
                        hardware,
                        model.heights(),
                        model.carriers()),
                spec.mapFromBase(),
                spec.color(),
                spec.marker());
    }

    /// A robot with what its computer does.
    ///
    /// @param computers drivers, in this order
    public static Robot equipped(Robot bare, List<DeviceDriver> computers, Config config, Scheduler scheduler) {
        Robot robot = bare;
        for (DeviceDriver driver : computers) {
            robot = robot.with(driver.create(
                    new DeviceDriver.Context(
                            driver.key(),
                            robot,
                            config.scene().map(),
                            Optional.empty(),
                            scheduler,
                            new SplittableRandom(config.seed())),
                    Arguments.defaults(driver.parameters())));
        }
        return robot;
    }
}
