package rsal.cli;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.Type;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
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
    private static final Path MODULES = Path.of("../../middle");
    private static final Path SOURCES = MODULES.resolve("devices/src/main/java");
    /// A method that others may call, on one line as the formatter leaves it.
    private static final Pattern METHOD = Pattern.compile(
            " {4}(public |default )?((?! |record|sealed|enum|class|static|private|protected|final)[\\w<>,.?\\[\\] ]+ \\w+\\(.*\\)) ?[;{]");

    private DeviceTypes() {}

    static String all() {
        return Stream.concat(
                        Stream.concat(interfaces(), DeviceKinds.all().stream().map(DeviceKind::makes)),
                        drivers().<Class<? extends Device>>map(DeviceDriver::makes))
                .distinct()
                .sorted((one, other) -> one.getSimpleName().compareTo(other.getSimpleName()))
                .map(DeviceTypes::section)
                .collect(Collectors.joining("\n"));
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
        Source source = Source.of(type);
        var text = new StringBuilder("### %s%n%n%s%n".formatted(type.getSimpleName(), source.about));
        var facts = new ArrayList<String>();
        reading(type).ifPresent(reading -> facts.add("Readings: " + reading));
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
        facts.add("In Java: [`%s`](../../%s)"
                .formatted(type.getName(), Path.of("../..").relativize(Source.file(type))));
        facts.forEach(fact -> text.append("\n* ").append(fact));
        text.append('\n');
        if (!source.methods.isEmpty()) {
            var table = new Markdown.Table("method", "");
            source.methods.forEach(method -> table.row(Markdown.code(method.signature), method.about));
            text.append('\n').append(table);
        }
        return text.toString();
    }

    private static Optional<String> reading(Class<?> type) {
        return Stream.concat(Stream.of(type.getGenericInterfaces()), Stream.ofNullable(type.getGenericSuperclass()))
                .filter(ParameterizedType.class::isInstance)
                .map(ParameterizedType.class::cast)
                .map(parent -> parent.getActualTypeArguments()[0])
                .map(Type::getTypeName)
                .map(name -> Markdown.code(name.substring(name.lastIndexOf('.') + 1)))
                .findFirst();
    }

    private record Method(String signature, String about) {}

    /// What a source says to those who use it.
    private record Source(String about, List<Method> methods) {
        static Source of(Class<?> type) {
            String about = "";
            var methods = new ArrayList<Method>();
            var doc = new ArrayList<String>();
            for (String line : lines(type)) {
                String text = line.strip();
                if (text.startsWith("///")) {
                    doc.add(text.substring(3).strip());
                    continue;
                }
                Matcher method = METHOD.matcher(line);
                if (text.startsWith("public ") && text.contains(" " + type.getSimpleName()) && about.isEmpty()) {
                    about = told(doc);
                } else if (method.matches() && (type.isInterface() || "public ".equals(method.group(1)))) {
                    methods.add(new Method(method.group(2), Markdown.firstSentence(told(doc))));
                }
                doc.clear();
            }
            return new Source(about, methods);
        }

        /// In whichever module of the middle layer it is.
        static Path file(Class<?> type) {
            String inModule = "src/main/java/" + type.getName().replace('.', '/') + ".java";
            try (Stream<Path> modules = Files.list(MODULES)) {
                return modules.map(module -> module.resolve(inModule))
                        .filter(Files::exists)
                        .findFirst()
                        .orElseThrow();
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        private static List<String> lines(Class<?> type) {
            try {
                return Files.readAllLines(file(type));
            } catch (IOException e) {
                throw new UncheckedIOException(e);
            }
        }

        /// The words of a doc comment, with names of other types as code.
        private static String told(List<String> doc) {
            String words = doc.stream()
                    .takeWhile(line -> !line.startsWith("@"))
                    .map(line -> line.isEmpty() ? "\n\n" : line)
                    .collect(Collectors.joining(" "))
                    .replaceAll(" *\n\n *", "\n\n")
                    .replaceAll("\\[([^\\]]+)\\]\\[[^\\]]+\\]", "$1")
                    .replaceAll("\\[(?:#(\\w+)|([A-Z]\\w*))\\]", "`$1$2`") // no units: [m]
                    .strip();
            return words;
        }
    }
}
