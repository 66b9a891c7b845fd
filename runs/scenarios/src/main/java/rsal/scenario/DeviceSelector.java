package rsal.scenario;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Optional;
import rsal.behavior.Pilot;
import rsal.device.Device;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.device.RangeSensor;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.robot.RobotSpec;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedDevice;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.RunPlan.Spare;
import rsal.scenario.RunPlan.Spares;
import rsal.scenario.installed.Catalog;
import rsal.settings.Arguments;

/// Decides which software devices robots can be given that their scenario gives them none of.
final class DeviceSelector {
    private static final String PILOT = "pilot";
    private static final String NAVIGATOR = "navigator";
    private static final String LOCALIZER = "localizer";
    private static final String EXACT = "odometry";
    private static final String SEARCHING = "amcl";

    private final Catalog catalog;
    private final Seeds seeds;

    DeviceSelector(Catalog catalog, Seeds seeds) {
        this.catalog = catalog;
        this.seeds = seeds;
    }

    /// @param drivers of the devices that it has anyway: what replaces one of those is made like it
    PlannedRobot robot(RobotSpec spec, Mrs mrs, List<PlannedDevice> drivers) {
        return new PlannedRobot(spec, mrs, drivers, new Spares(pilot(spec, drivers), navigation(spec, drivers)));
    }

    private Spare pilot(RobotSpec spec, List<PlannedDevice> drivers) {
        return spare(spec, List.of(like(Pilot.class, drivers, spec, PILOT, PILOT)));
    }

    private Spare navigation(RobotSpec spec, List<PlannedDevice> drivers) {
        return spare(
                spec,
                List.of(
                        like(Localizer.class, drivers, spec, LOCALIZER, isExact(spec.model()) ? EXACT : SEARCHING),
                        like(Navigator.class, drivers, spec, NAVIGATOR, NAVIGATOR)));
    }

    private static boolean isExact(RobotModel model) {
        RobotModel.OdometryNoise noise = model.drive().odometryNoise();
        return noise.distancePerMeter() == 0 && noise.headingPerMeter() == 0 && noise.headingPerRadian() == 0;
    }

    private Optional<PlannedDevice> like(
            Class<? extends Device> type, List<PlannedDevice> drivers, RobotSpec spec, String name, String key) {
        return drivers.stream()
                .filter(device -> type.isAssignableFrom(device.driver().makes()))
                .findFirst()
                .or(() -> Optional.ofNullable(catalog.drivers().get(key))
                        .map(driver -> new PlannedDevice(
                                name,
                                driver,
                                Arguments.defaults(driver.parameters()),
                                seeds.of("device/" + spec.id() + "/" + name))));
    }

    private static Spare spare(RobotSpec spec, List<Optional<PlannedDevice>> wanted) {
        List<PlannedDevice> devices = wanted.stream().flatMap(Optional::stream).toList();
        if (devices.size() < wanted.size()) {
            return Spare.none("No device driver for that is installed.");
        }
        for (PlannedDevice device : devices) {
            Optional<String> refusal = device.driver().refusal(spec.model());
            if (refusal.isPresent()) {
                return Spare.none(refusal.get());
            }
        }
        return has(spec.model(), RangeSensor.class)
                ? new Spare(devices, "")
                : Spare.none("It has no sensor that measures ranges, so it would drive blindly.");
    }

    static boolean has(RobotModel model, Class<? extends Device> type) {
        return model.sensors().values().stream().anyMatch(part -> type.isAssignableFrom(part.makes()));
    }

    /// Types of the devices that a robot can be given.
    static List<Class<? extends Device>> gives(PlannedRobot robot) {
        var types = new ArrayList<Class<? extends Device>>();
        for (Spare spare : robot.spares().all()) {
            spare.devices().forEach(device -> types.add(device.driver().makes()));
        }
        return types;
    }

    /// The robot with those of its spare devices, from the start, that somebody needs, and with those that they need.
    static PlannedRobot equipped(PlannedRobot robot, Collection<Class<? extends Device>> needs) {
        var drivers = new ArrayList<>(robot.drivers());
        for (Spare spare : robot.spares().all()) {
            int last = -1;
            for (int i = 0; i < spare.devices().size(); i++) {
                DeviceDriver driver = spare.devices().get(i).driver();
                last = needs.stream().anyMatch(need -> need.isAssignableFrom(driver.makes())) ? i : last;
            }
            spare.devices().stream()
                    .limit(last + 1)
                    .filter(device -> !has(robot.spec().model(), device.driver().makes()))
                    .filter(device -> drivers.stream()
                            .noneMatch(own ->
                                    own.driver().makes().equals(device.driver().makes())))
                    .forEach(drivers::add);
        }
        return drivers.size() == robot.drivers().size() ? robot : robot.with(drivers);
    }
}
