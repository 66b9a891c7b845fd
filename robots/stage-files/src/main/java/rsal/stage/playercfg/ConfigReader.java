package rsal.stage.playercfg;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rsal.settings.Location;
import rsal.settings.Value;
import rsal.stage.WorldFile;
import rsal.stage.WorldProblems;
import rsal.stage.WorldfileEntity;
import rsal.stage.WorldfileEntity.Setting;

/// Turns what is written into drivers and addresses.
final class ConfigReader {
    private static final Set<String> OF_ALL = Set.of("name", "provides", "requires", "plugin", "alwayson");
    private static final String SERVER = "server";
    private static final String ADDRESS = "Write 'position2d:0', with a server's port (6665:position2d:0), or with"
            + " a key and its port (odometry::6665:position2d:0).";

    private final String path;
    private final WorldFile file;
    private final WorldProblems findings;
    private final Set<String> interfaces = new TreeSet<>(Interfaces.ALL);
    private final Map<String, Integer> ports = new LinkedHashMap<>(); // by file, of devices that name none

    ConfigReader(String path, WorldFile file, WorldProblems findings) {
        this.path = path;
        this.file = file;
        this.findings = findings;
    }

    PlayerConfig config() {
        WorldfileEntity root = file.root();
        double meters = switch (choice(root, "unit_length", List.of("m", "cm", "mm"))) {
            case "cm" -> 0.01;
            case "mm" -> 0.001;
            default -> 1;
        };
        boolean radians =
                choice(root, "unit_angle", List.of("degrees", "radians")).equals("radians");
        for (Setting setting : root.settings().values()) {
            if (!setting.name().equals("unit_length") && !setting.name().equals("unit_angle")) {
                findings.warn(
                        setting.location(),
                        "'%s' has no effect outside of a driver.".formatted(WorldProblems.shortened(setting.name())),
                        findings.maybe(
                                setting.name(), List.of("unit_length", "unit_angle"), "Maybe a ) is missing below."));
            }
        }
        root.children().stream()
                .filter(block -> block.type().equals("interface"))
                .forEach(this::addInterface);
        root.children().stream().filter(block -> block.type().equals(SERVER)).forEach(this::addServer);
        var drivers = new ArrayList<Driver>();
        for (WorldfileEntity block : root.children()) {
            switch (block.type()) {
                case "driver" -> driver(block).ifPresent(drivers::add);
                case "interface", SERVER -> {}
                default -> unknown(block);
            }
        }
        checkUnique(drivers);
        return new PlayerConfig(path, meters, radians ? 1 : Math.toRadians(1), drivers);
    }

    private String choice(WorldfileEntity entity, String name, List<String> words) {
        Optional<Setting> setting = entity.find(name);
        Optional<String> word = setting.flatMap(s -> text(s.value()));
        if (setting.isPresent() && word.filter(words::contains).isEmpty()) {
            findings.error(
                    setting.get().value().location(),
                    "'%s' must be one of %s, not %s."
                            .formatted(
                                    name,
                                    words,
                                    WorldProblems.shortened(
                                            setting.get().value().describe())),
                    "");
        }
        return word.filter(words::contains).orElse(words.getFirst());
    }

    /// An interface that a plugin brings along.
    private void addInterface(WorldfileEntity block) {
        Optional<String> name = block.find("name").flatMap(s -> text(s.value()));
        if (name.isEmpty()) {
            findings.error(block.location(), "This 'interface' has no 'name'.", "Write name \"NAME\".");
        }
        name.ifPresent(interfaces::add);
    }

    /// What `player -p PORT FILE` says of a file that is included here. Not one of Player's blocks.
    private void addServer(WorldfileEntity block) {
        Optional<String> name = block.find("file").flatMap(s -> text(s.value())).filter(n -> !n.isBlank());
        Optional<Double> port = block.find("port")
                .map(Setting::value)
                .filter(value -> value instanceof Value.Scalar scalar && scalar.value() instanceof Number)
                .map(value -> ((Number) ((Value.Scalar) value).value()).doubleValue())
                .filter(DriverAddress::isPort);
        if (name.isEmpty() || port.isEmpty()) {
            findings.error(
                    block.location(),
                    "A 'server' needs a 'file' and a 'port' from 1 to 65535.",
                    "Write server ( file \"planner.cfg\" port 6666 ).");
        } else if (ports.put(name.get(), port.get().intValue()) != null) {
            findings.error(
                    block.location(),
                    "'%s' has two ports.".formatted(WorldProblems.shortened(name.get())),
                    "Remove one 'server'.");
        } else if (file.root().children().stream().noneMatch(other -> isIn(name.get(), other.location()))) {
            findings.error(
                    block.location(),
                    "Nothing of '%s' is included here.".formatted(WorldProblems.shortened(name.get())),
                    "Write include \"%s\" above.".formatted(WorldProblems.shortened(name.get())));
        }
    }

    private static boolean isIn(String file, Location location) {
        return location.file().equals(file) || location.file().endsWith("/" + file);
    }

    private DriverAddress at(DriverAddress address) {
        return ports.entrySet().stream()
                .filter(server -> isIn(server.getKey(), address.location()))
                .findFirst()
                .map(server -> address.at(server.getValue()))
                .orElse(address);
    }

    private void unknown(WorldfileEntity block) {
        String type = WorldProblems.shortened(block.type());
        String message = "'%s' is neither a 'driver' nor an 'interface' nor a macro of one".formatted(type);
        if (file.complete()) { // else what was not included may define it
            Optional<String> close = findings.guess(type, file.known());
            if (close.isPresent()) {
                findings.error(block.location(), message + ".", "Maybe '%s' was meant?".formatted(close.get()));
            } else {
                findings.warn(block.location(), message + "; it is ignored.", "Maybe an include is missing.");
            }
        }
    }

    private Optional<Driver> driver(WorldfileEntity block) {
        Optional<String> name = block.find("name").flatMap(s -> text(s.value())).filter(n -> !n.isBlank());
        if (name.isEmpty()) {
            findings.error(
                    block.location(), "This 'driver' has no 'name'.", "Write name \"stage\" or another driver's.");
            return Optional.empty();
        }
        List<DriverAddress> provides = addresses(block, "provides");
        if (block.find("provides").isEmpty()) {
            findings.error(
                    block.location(),
                    "'%s' provides nothing.".formatted(WorldProblems.shortened(name.get())),
                    "Write provides [ \"INTERFACE:INDEX\" ].");
        }
        for (WorldfileEntity child : block.children()) {
            findings.warn(
                    child.location(),
                    "'%s' has no effect in a driver.".formatted(WorldProblems.shortened(child.macro())),
                    "Maybe a ) is missing above.");
        }
        Optional<String> plugin = block.find("plugin").flatMap(s -> text(s.value()));
        var options = new LinkedHashMap<String, Driver.Option>();
        for (Setting setting : block.settings().values()) {
            if (!OF_ALL.contains(setting.name())) {
                options.put(setting.name(), new Driver.Option(setting.name(), setting.location(), setting.value()));
            }
        }
        checkName(name.get(), block, plugin);
        checkOptions(name.get(), options);
        return Optional.of(new Driver(
                name.get(),
                block.location(),
                provides,
                addresses(block, "requires"),
                plugin,
                block.find("alwayson").map(s -> isTrue(s.value())).orElse(false),
                options));
    }

    private void checkName(String name, WorldfileEntity block, Optional<String> plugin) {
        if (plugin.isEmpty() && !KnownDrivers.names().contains(name)) {
            findings.guess(name, KnownDrivers.names())
                    .ifPresent(close -> findings.error(
                            block.find("name").map(Setting::location).orElse(block.location()),
                            "There is no driver '%s'.".formatted(WorldProblems.shortened(name)),
                            "Maybe '%s' was meant?".formatted(close)));
        }
    }

    private void checkOptions(String driver, Map<String, Driver.Option> options) {
        Optional<Set<String>> known = KnownDrivers.options(driver);
        if (known.isEmpty()) {
            return;
        }
        var reported = new LinkedHashSet<String>();
        for (Driver.Option option : options.values()) {
            int index = option.name().indexOf('[');
            String family = index > 0 ? option.name().substring(0, index) : option.name();
            if (!known.get().contains(family) && reported.add(family)) {
                findings.warn(
                        option.location(),
                        "'%s' is not known in a driver '%s' and has no effect."
                                .formatted(WorldProblems.shortened(option.name()), driver),
                        KnownDrivers.whyNeverRead(driver, family)
                                .orElseGet(() -> findings.maybe(family, known.get(), "")));
            }
        }
    }

    private List<DriverAddress> addresses(WorldfileEntity block, String name) {
        var addresses = new ArrayList<DriverAddress>();
        Value value = block.find(name).map(Setting::value).orElse(null);
        if (value instanceof Value.Sequence sequence) {
            sequence.items().forEach(item -> address(item, name).ifPresent(addresses::add));
        } else if (value != null) {
            address(value, name).ifPresent(addresses::add);
        }
        return addresses;
    }

    private Optional<DriverAddress> address(Value value, String name) {
        Optional<DriverAddress> read = text(value).flatMap(text -> DriverAddress.parse(text, value.location()));
        if (read.isEmpty()) {
            findings.error(
                    value.location(),
                    "'%s' has %s, which is not a device.".formatted(name, WorldProblems.shortened(value.describe())),
                    ADDRESS);
            return read;
        }
        DriverAddress address = at(read.get());
        if (!interfaces.contains(address.type())) {
            findings.error(
                    value.location(),
                    "There is no interface '%s'.".formatted(WorldProblems.shortened(address.type())),
                    address.type().equals("position") // as it was called before there were others
                            ? "Maybe 'position2d' was meant?"
                            : findings.maybe(address.type(), interfaces, ""));
            return Optional.empty();
        }
        if (isMisplacedKey(address)) {
            findings.warn(
                    value.location(),
                    "'%s' is taken for a host here.".formatted(WorldProblems.shortened(address.host())),
                    "Maybe it is a key: write (%s:::%s)."
                            .formatted(WorldProblems.shortened(address.host()), address.device()));
        }
        return Optional.of(address);
    }

    /// `odometry::position2d:0` lacks a colon.
    private static boolean isMisplacedKey(DriverAddress address) {
        return address.key().isEmpty()
                && address.port().isEmpty()
                && !address.isHere()
                && address.host().indexOf('.') < 0;
    }

    private void checkUnique(List<Driver> drivers) {
        var known = new HashMap<String, Location>();
        for (Driver driver : drivers) {
            for (DriverAddress address : driver.provides()) {
                Location first = known.putIfAbsent(address.place(), address.location());
                if (first != null) {
                    findings.error(
                            address.location(),
                            "'%s' is provided twice; the first time at %s.".formatted(address.place(), first),
                            "Give one of them another index or port.");
                }
            }
        }
    }

    /// A text; empty when a value is something else.
    static Optional<String> text(Value value) {
        return value instanceof Value.Scalar scalar && scalar.value() instanceof String text
                ? Optional.of(text)
                : Optional.empty();
    }

    private static boolean isTrue(Value value) {
        return value instanceof Value.Scalar scalar
                && (Boolean.TRUE.equals(scalar.value())
                        || (scalar.value() instanceof Number number && number.doubleValue() != 0));
    }
}
