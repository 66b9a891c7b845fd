package rsal.scenario;

import java.util.ArrayList;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.device.Device;
import rsal.device.DriveBase;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.robot.RobotModel;
import rsal.scenario.installed.Catalog;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads what robots of a role are and carry: parts go into the model, drivers are made later, in the order in
/// which they are written.
final class DeviceReader {
    private final Catalog catalog;
    private final RobotModels models;
    private final Problems problems;

    DeviceReader(Catalog catalog, RobotModels models, Problems problems) {
        this.catalog = catalog;
        this.models = models;
        this.problems = problems;
    }

    /// @param model with its parts; empty when it can't be read
    /// @param has types of all devices
    record Equipment(Optional<RobotModel> model, List<Driver> drivers, List<Class<? extends Device>> has) {}

    /// @param name of the device that it makes
    record Driver(String name, DeviceDriver driver, Arguments options) {}

    /// @param robot the role's settings
    Equipment read(Section robot) {
        Section devices = robot.section("devices");
        var parts = new LinkedHashMap<String, RobotModels.Choice>();
        var software = new LinkedHashMap<String, DeviceDriver>();
        for (String name : devices.names()) {
            if (!devices.isMapping(name) && isPart(devices.text(name))) {
                parts.put(name, new RobotModels.Choice(devices.text(name), devices.locationOf(name)));
            } else {
                driver(devices, name).ifPresent(driver -> software.put(name, driver));
            }
        }
        Optional<RobotModel> model = model(robot, parts);
        var has = new ArrayList<Class<? extends Device>>(List.of(DriveBase.class));
        model.ifPresent(m -> m.sensors().values().forEach(part -> has.add(part.makes())));
        var drivers = new ArrayList<Driver>();
        var before = new ArrayList<DeviceDriver>();
        software.forEach((name, driver) -> {
            model.ifPresent(m -> {
                if (hasNeeds(devices, name, driver, has)) {
                    driver.refusal(m)
                            .or(() -> driver.refusal(List.copyOf(before)))
                            .ifPresent(why -> refuse(devices, name, driver, why));
                }
            });
            before.add(driver);
            has.add(driver.makes());
            options(devices, name, driver).ifPresent(options -> {
                driver.refusal(options).ifPresent(why -> misset(devices, name, driver, why));
                drivers.add(new Driver(name, driver, options));
            });
        });
        return new Equipment(model, drivers, has);
    }

    private boolean isPart(String word) {
        return catalog.parts().contains(word)
                || word.equals(RobotModels.NO_PART)
                || word.endsWith(".yaml")
                || word.endsWith(".yml");
    }

    private Optional<DeviceDriver> driver(Section devices, String name) {
        if (devices.isMapping(name)) {
            Section options = devices.section(name);
            return Catalog.find(
                    "device driver",
                    catalog.drivers(),
                    options.text("type", name),
                    options.locationOf("type"),
                    problems);
        }
        String word = devices.text(name);
        var driver = Optional.ofNullable(catalog.drivers().get(word));
        if (driver.isEmpty() && !word.isEmpty()) {
            var known = new ArrayList<>(catalog.parts());
            known.addAll(catalog.drivers().keySet());
            devices.problem(
                    name, "There is no part or device driver '%s'.".formatted(word), Suggestion.among(word, known));
        }
        return driver;
    }

    private Optional<Arguments> options(Section devices, String name, DeviceDriver driver) {
        Section options = devices.isMapping(name)
                ? devices.section(name)
                : new Section(devices.path(name), Value.Mapping.empty(devices.locationOf(name)), problems);
        options.has("type");
        for (String option : options.names()) {
            boolean known = driver.parameters().stream()
                    .anyMatch(parameter -> parameter.name().equals(option));
            driver.advice(option).filter(_ -> !known).ifPresent(advice -> {
                options.has(option);
                Location place = options.mapping().keys().getOrDefault(option, options.location());
                options.problem(place, "'%s' is not known in '%s'.".formatted(option, devices.path(name)), advice);
            });
        }
        return options.arguments(driver.parameters());
    }

    private Optional<RobotModel> model(Section robot, Map<String, RobotModels.Choice> parts) {
        String name = robot.text("model");
        if (name.isEmpty()) {
            return Optional.empty();
        }
        try {
            return Optional.of(models.read(name, robot.locationOf("model"), parts));
        } catch (InvalidSettings e) {
            problems.addAll(e);
            return Optional.empty();
        }
    }

    private static boolean hasNeeds(
            Section devices, String name, DeviceDriver driver, List<Class<? extends Device>> has) {
        var missing = missing(has, driver.needs());
        if (!missing.isEmpty()) {
            devices.problem(
                    name,
                    "Device driver '%s' needs %s, which the robot does not have before '%s'."
                            .formatted(driver.key(), words(missing), name),
                    "Add it to 'devices', above '%s'.".formatted(name));
        }
        return missing.isEmpty();
    }

    private static void refuse(Section devices, String name, DeviceDriver driver, String why) {
        devices.problem(name, "Device driver '%s' can't work on this robot.".formatted(driver.key()), why);
    }

    private static void misset(Section devices, String name, DeviceDriver driver, String why) {
        devices.problem(name, "Device driver '%s' can't work with these options.".formatted(driver.key()), why);
    }

    static List<Class<? extends Device>> missing(
            List<Class<? extends Device>> has, List<Class<? extends Device>> needs) {
        return needs.stream()
                .filter(need -> has.stream().noneMatch(need::isAssignableFrom))
                .toList();
    }

    /// In messages: `a LaserScanner and a DriveBase`.
    static String words(Collection<Class<? extends Device>> types) {
        return types.stream().map(type -> "a " + type.getSimpleName()).collect(Collectors.joining(" and "));
    }
}
