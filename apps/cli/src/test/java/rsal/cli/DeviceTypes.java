package rsal.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.ParameterizedType;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.cli.show.ShownPart;
import rsal.device.Device;
import rsal.device.Sensor;
import rsal.model.RobotModels;
import rsal.robot.DeviceDriver;
import rsal.robot.DeviceKind;
import rsal.robot.DeviceKinds;
import rsal.robot.RobotModel.Part;
import rsal.scenario.installed.Providers;
import rsal.settings.Location;

/// The types of devices, as their sources tell of them, and what becomes one.
final class DeviceTypes {
    private static final Path SOURCES = Path.of("../../middle/devices/src/main/java");

    private DeviceTypes() {}

    static String all() {
        return types().map(DeviceTypes::section).collect(Collectors.joining("\n"));
    }

    private static Stream<Class<? extends Device>> types() {
        return Stream.concat(
                        Stream.concat(interfaces(), DeviceKinds.all().stream().map(DeviceKind::makes)),
                        drivers().<Class<? extends Device>>map(DeviceDriver::makes))
                .distinct()
                .sorted(Comparator.comparing(Class::getSimpleName));
    }

    static String parts() {
        var table = new Markdown.Table("part", "`type`", "device", "");
        for (String name : RobotModels.builtInParts()) {
            ShownPart part = ShownPart.of(name).orElseThrow();
            Matcher type = Pattern.compile("(?m)^type: (.*)$").matcher(part.file());
            String device = made(name).makes().getSimpleName();
            table.row(
                    Markdown.code(name),
                    type.find() ? Markdown.code(type.group(1)) : "",
                    "[%s](devices.md#%s)".formatted(device, Markdown.anchor(device)),
                    Markdown.text(part.title()) + ".");
        }
        return table.toString();
    }

    private static Stream<Class<? extends Device>> interfaces() {
        try (Stream<Path> files = Files.list(SOURCES.resolve("rsal/device"))) {
            return files
                    .filter(Files::isRegularFile)
                    .map(file -> "rsal.device." + file.getFileName().toString().replace(".java", ""))
                    .filter(name -> !name.endsWith("package-info"))
                    .<Class<?>>map(DeviceTypes::load)
                    .filter(type -> type.isInterface() && Device.class.isAssignableFrom(type))
                    .filter(type -> type != Device.class && type != Sensor.class)
                    .<Class<? extends Device>>map(type -> type.asSubclass(Device.class))
                    .toList()
                    .stream();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private static Class<?> load(String name) {
        try {
            return Class.forName(name);
        } catch (ClassNotFoundException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Stream<DeviceDriver> drivers() {
        return Providers.byKey(DeviceDriver.class, DeviceDriver::key).values().stream();
    }

    private static Part made(String part) {
        String model = """
                title: Bench
                body: {radius: 0.3}
                drive:
                  maxSpeed: 1
                  maxTurnRate: 90
                  maxAcceleration: 1
                  maxTurnAcceleration: 90
                  odometryNoise: {distancePerMeter: 0, headingPerMeter: 0, headingPerDegree: 0}
                mounts: {it: [0, 0, 0]}
                sensors: {it: %s}
                """.formatted(part);
        return Objects.requireNonNull(new RobotModels((_, _, _) -> model.getBytes(StandardCharsets.UTF_8))
                .read("bench.yaml", Location.of("bench.yaml"))
                .sensors()
                .get("it"));
    }

    private static String section(Class<? extends Device> type) {
        SourceText source = SourceText.of(type);
        var text = new StringBuilder("### %s%n%n%s%n".formatted(type.getSimpleName(), source.about()));
        var facts = new ArrayList<String>();
        reading(type)
                .map(Class::getSimpleName)
                .ifPresent(reading ->
                        facts.add("Readings: [`%s`](messages.md#%s)".formatted(reading, Markdown.anchor(reading))));
        String parts = RobotModels.builtInParts().stream()
                .filter(part -> type == made(part).makes())
                .map(Markdown::code)
                .collect(Collectors.joining(", "));
        if (!parts.isEmpty()) {
            facts.add("[Parts](robot-models.md#parts): " + parts);
        }
        String drivers = drivers()
                .filter(driver -> driver.makes() == type)
                .map(driver -> "[`%s`](#type-%s)".formatted(driver.key(), Markdown.anchor(driver.key())))
                .collect(Collectors.joining(", "));
        if (!drivers.isEmpty()) {
            facts.add("Drivers: " + drivers);
        }
        facts.add("In Java: " + SourceText.link(type));
        facts.forEach(fact -> text.append("\n* ").append(fact));
        text.append('\n');
        if (!source.methods().isEmpty()) {
            var table = new Markdown.Table("method", "");
            source.methods().forEach(method -> table.row(Markdown.code(method.signature()), method.about()));
            text.append('\n').append(table);
        }
        return text.toString();
    }

    /// The types of all readings, each once.
    static Stream<Class<?>> readings() {
        return types().flatMap(type -> reading(type).stream()).distinct();
    }

    private static Optional<Class<?>> reading(Class<?> type) {
        return Stream.concat(Stream.of(type.getGenericInterfaces()), Stream.ofNullable(type.getGenericSuperclass()))
                .filter(ParameterizedType.class::isInstance)
                .map(ParameterizedType.class::cast)
                .<Class<?>>map(parent -> (Class<?>) parent.getActualTypeArguments()[0])
                .findFirst();
    }
}
