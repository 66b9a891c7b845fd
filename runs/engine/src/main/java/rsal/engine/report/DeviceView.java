package rsal.engine.report;

import java.util.List;
import java.util.Set;
import rsal.behavior.Pilot;
import rsal.device.Actuator;
import rsal.device.Battery;
import rsal.device.BlobFinder;
import rsal.device.Bumper;
import rsal.device.Device;
import rsal.device.Docking;
import rsal.device.DriveBase;
import rsal.device.FiducialFinder;
import rsal.device.Gripper;
import rsal.device.Health;
import rsal.device.LaserScanner;
import rsal.device.Light;
import rsal.device.Localizer;
import rsal.device.Mapper;
import rsal.device.Navigator;
import rsal.device.PlaceFinder;
import rsal.device.Planner;
import rsal.device.RangeSensor;
import rsal.device.Sensor;
import rsal.device.SimulationControl;
import rsal.device.SonarArray;

/// A device as people see it.
///
/// @param name within its robot (`laser`)
/// @param driver what makes it work (`sim`, `amcl`)
/// @param type what it is (`LaserScanner`)
public record DeviceView(String name, String driver, String type, Health health) {
    /// What a device can be, the most special first.
    private static final List<Class<? extends Device>> CONTRACTS = List.of(
            DriveBase.class,
            LaserScanner.class,
            SonarArray.class,
            BlobFinder.class,
            FiducialFinder.class,
            Gripper.class,
            Bumper.class,
            Actuator.class,
            Battery.class,
            Light.class,
            Localizer.class,
            Mapper.class,
            Navigator.class,
            Planner.class,
            Docking.class,
            PlaceFinder.class,
            Pilot.class,
            SimulationControl.class);

    private static final Set<Class<?>> GENERAL = Set.of(Device.class, Sensor.class, RangeSensor.class);

    /// The contract that devices of a class fulfil: `LaserScanner`.
    private static final ClassValue<String> TYPES = new ClassValue<>() {
        @Override
        protected String computeValue(Class<?> device) {
            return CONTRACTS.stream()
                    .filter(contract -> contract.isAssignableFrom(device))
                    .map(Class::getSimpleName)
                    .findFirst()
                    .orElseGet(() -> own(device));
        }
    };

    /// Of a kind that nobody thought of here: the first of its interfaces that says more than that it is a
    /// device.
    private static String own(Class<?> device) {
        for (Class<?> type = device; type != null; type = type.getSuperclass()) {
            for (Class<?> contract : type.getInterfaces()) {
                if (Device.class.isAssignableFrom(contract) && !GENERAL.contains(contract)) {
                    return contract.getSimpleName();
                }
            }
        }
        return "Device";
    }

    public static DeviceView of(Device device) {
        return new DeviceView(
                device.info().name(), device.info().driver(), TYPES.get(device.getClass()), device.health());
    }
}
