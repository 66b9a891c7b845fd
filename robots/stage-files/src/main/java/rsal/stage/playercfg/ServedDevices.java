package rsal.stage.playercfg;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.IdentityHashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import rsal.scene.RobotService;
import rsal.scene.RobotService.Software;
import rsal.settings.Location;
import rsal.settings.Problem;
import rsal.settings.Value;
import rsal.stage.ModelKind;
import rsal.stage.RobotMaker;
import rsal.stage.StageModel;
import rsal.stage.StageWorld;
import rsal.stage.WorldProblems;

/// Finds out what of a world a configuration's drivers serve: Stage its models, others what they make of what
/// Stage or others serve.
final class ServedDevices {
    private static final int MOST_NAMED = 8; // of models in a message
    private static final String CONTROLLER = "controller";
    private static final String LOCALIZER = "localizer";
    private static final String NAVIGATOR = "navigator";

    private final PlayerConfig config;
    private final StageWorld world;
    private final WorldProblems findings;
    private final Options options;
    private final Map<String, StageModel> models = new LinkedHashMap<>();
    private final Map<String, Part> parts = new HashMap<>(); // by the names of their models
    private final Map<String, Source> sources = new HashMap<>(); // by place
    private final IdentityHashMap<Driver, String> robots = new IdentityHashMap<>(); // that they serve
    private final IdentityHashMap<Driver, Problem> refusals = new IdentityHashMap<>();
    private final Map<String, Navigation> navigations = new LinkedHashMap<>(); // by robot

    /// What a model becomes.
    ///
    /// @param device empty when it becomes none
    private record Part(String robot, Optional<String> device) {}

    /// What stands behind a device that is served.
    ///
    /// @param robot empty when it is not a robot's
    private record Source(Optional<String> robot, String device) {}

    /// Drivers by which a robot finds its way.
    private record Navigation(Optional<Driver> localizing, Optional<Driver> avoiding, Optional<Driver> planning) {
        Stream<Driver> all() {
            return Stream.of(localizing, avoiding, planning).flatMap(Optional::stream);
        }
    }

    ServedDevices(PlayerConfig config, StageWorld world, WorldProblems findings) {
        this.config = config;
        this.world = world;
        this.findings = findings;
        this.options = new Options(config, findings);
        world.forEach(model -> models.put(model.name(), model));
        world.models().forEach(this::findRobots);
    }

    private void findRobots(StageModel model) {
        if (model.traits().kind() instanceof ModelKind.Position) {
            String robot = model.name().replace('/', '.');
            Map<String, String> devices = RobotMaker.devices(model, world.step());
            model.forEach(part ->
                    parts.put(part.name(), new Part(robot, Optional.ofNullable(devices.get(part.name())))));
        } else {
            model.children().forEach(this::findRobots);
        }
    }

    /// What the drivers serve, by port, in their order.
    List<RobotService> services() {
        var waiting = new ArrayList<Driver>();
        for (Driver driver : config.drivers()) {
            if (driver.name().equals(KnownDrivers.STAGE)) {
                model(driver).flatMap(base -> serve(driver, base)).ifPresent(robot -> robots.put(driver, robot));
                driver.provides().stream()
                        .filter(address -> address.type().equals(Interfaces.SIMULATION))
                        .forEach(address -> provide(address, new Source(Optional.empty(), RobotService.SIMULATION)));
            } else {
                waiting.add(driver);
            }
        }
        boolean goesOn = true;
        while (goesOn) { // what one needs may stand behind it
            goesOn = waiting.removeIf(this::connect);
        }
        waiting.forEach(this::refuseUnconnected);
        for (Driver driver : config.drivers()) {
            Problem refusal = refusals.get(driver);
            if (refusal != null) {
                findings.warn(
                        driver.location(),
                        "'%s' has no effect in a run.".formatted(WorldProblems.shortened(driver.name())),
                        KnownDrivers.instead(driver.name()));
            }
        }
        IdentityHashMap<Driver, List<Software>> software = software();
        return config.drivers().stream()
                .flatMap(driver -> services(driver, software.getOrDefault(driver, List.of())))
                .toList();
    }

    private Stream<RobotService> services(Driver driver, List<Software> software) {
        var byPort = new LinkedHashMap<Integer, List<DriverAddress>>();
        for (DriverAddress address : driver.provides()) {
            byPort.computeIfAbsent(address.portOrUsual(), _ -> new ArrayList<>())
                    .add(address);
        }
        var services = new ArrayList<RobotService>();
        byPort.forEach((port, addresses) -> services.add(new RobotService(
                driver.name(),
                driver.location(),
                port,
                addresses.stream().map(DriverAddress::device).toList(),
                driver.requires().stream().map(DriverAddress::place).toList(),
                Optional.ofNullable(robots.get(driver)),
                behind(addresses),
                services.isEmpty() ? software : List.of(), // once is enough
                options.tolerance(driver),
                Optional.ofNullable(refusals.get(driver)))));
        return services.stream();
    }

    private Map<String, String> behind(List<DriverAddress> addresses) {
        var behind = new LinkedHashMap<String, String>();
        addresses.forEach(address -> Optional.ofNullable(sources.get(address.place()))
                .ifPresent(source -> behind.put(address.device(), source.device())));
        return behind;
    }

    private void provide(DriverAddress address, Source source) {
        sources.put(address.place(), source);
    }

    /// Finds what stands behind what a driver provides.
    ///
    /// @return whether what it needs is known, or it is refused
    private boolean connect(Driver driver) {
        return switch (driver.name()) {
            case "mapfile" -> {
                driver.provides().forEach(address -> provide(address, new Source(Optional.empty(), RobotService.MAP)));
                yield true;
            }
            case "rangertolaser" -> translate(driver, "ranger", "laser");
            case "lasertoranger" -> translate(driver, "laser", "laser");
            case "sonartoranger" -> translate(driver, "sonar", "sonar");
            case "amcl", "vfh", "nd", "snd", "wavefront" -> navigate(driver);
            default -> {
                Optional<String> close = findings.guess(driver.name(), KnownDrivers.names());
                refuse(
                        driver,
                        "'%s' can't be served here.".formatted(WorldProblems.shortened(driver.name())),
                        close.map("Maybe '%s' was meant?"::formatted)
                                .filter(_ -> !KnownDrivers.names().contains(driver.name()))
                                .orElseGet(() -> KnownDrivers.instead(driver.name())));
                yield true;
            }
        };
    }

    private void refuse(Driver driver, String message, String remedy) {
        refusals.put(driver, new Problem(driver.location(), message, remedy));
    }

    private void refuseUnconnected(Driver driver) {
        DriverAddress missing = driver.requires().stream()
                .filter(address -> !sources.containsKey(address.place()))
                .findFirst()
                .orElse(null);
        if (missing == null) {
            refuse(driver, "'%s' requires nothing of a robot.".formatted(driver.name()), "Write requires [ ... ].");
        } else if (missing.isHere()) {
            refuse(
                    driver,
                    "'%s' requires '%s', which no driver of this file provides."
                            .formatted(driver.name(), missing.place()),
                    "Maybe another file does: write include \"FILE.cfg\" above it.");
        } else {
            refuse(
                    driver,
                    "'%s' requires '%s', which is on another computer."
                            .formatted(driver.name(), WorldProblems.shortened(missing.place())),
                    "Have one file with all drivers.");
        }
    }

    /// @param kind of our devices that it works with, by what their names begin with
    private boolean translate(Driver driver, String type, String kind) {
        Optional<DriverAddress> needed = driver.requires().stream()
                .filter(address -> address.type().equals(type))
                .findFirst();
        Optional<Source> source = needed.map(address -> sources.get(address.place()));
        if (source.isEmpty()) {
            return false;
        }
        if (!source.get().device().startsWith(kind)) {
            refuse(
                    driver,
                    "'%s' requires '%s', which is a '%s' and no '%s'."
                            .formatted(
                                    driver.name(),
                                    needed.get().place(),
                                    source.get().device(),
                                    kind),
                    "Maybe another one of the robot was meant.");
            return true;
        }
        source.get().robot().ifPresent(robot -> robots.put(driver, robot));
        driver.provides().forEach(address -> provide(address, source.get()));
        return true;
    }

    private boolean navigate(Driver driver) {
        List<DriverAddress> needed = driver.requires().stream()
                .filter(address ->
                        Set.of("position2d", "laser", "sonar", "ranger").contains(address.type()))
                .toList();
        if (needed.isEmpty() || !needed.stream().allMatch(address -> sources.containsKey(address.place()))) {
            return false;
        }
        Optional<String> robot = needed.stream()
                .map(address -> sources.get(address.place()))
                .flatMap(source -> source.robot().stream())
                .findFirst();
        if (robot.isEmpty()) {
            return false;
        }
        Navigation had = navigations.getOrDefault(
                robot.get(), new Navigation(Optional.empty(), Optional.empty(), Optional.empty()));
        Optional<Driver> own = Optional.of(driver);
        Optional<Driver> before = switch (driver.name()) {
            case "amcl" -> had.localizing;
            case "wavefront" -> had.planning;
            default -> had.avoiding;
        };
        if (before.isPresent()) {
            refuse(
                    driver,
                    "Robot '%s' has '%s' already, at %s."
                            .formatted(
                                    robot.get(),
                                    before.get().name(),
                                    before.get().location()),
                    "A robot has one at most.");
            return true;
        }
        navigations.put(
                robot.get(),
                switch (driver.name()) {
                    case "amcl" -> new Navigation(own, had.avoiding, had.planning);
                    case "wavefront" -> new Navigation(had.localizing, had.avoiding, own);
                    default -> new Navigation(had.localizing, own, had.planning);
                });
        robots.put(driver, robot.get());
        String device = driver.name().equals("amcl") ? LOCALIZER : NAVIGATOR;
        driver.provides().forEach(address -> provide(address, new Source(robot, device)));
        return true;
    }

    /// What the robots that find their way have to be given, each by the first of its drivers.
    private IdentityHashMap<Driver, List<Software>> software() {
        var software = new IdentityHashMap<Driver, List<Software>>();
        navigations.values().forEach(navigation -> {
            Driver first = navigation.all().findFirst().orElseThrow();
            var devices = new ArrayList<Software>();
            devices.add(navigation
                    .localizing()
                    .map(driver -> new Software(LOCALIZER, "amcl", options.settings(driver), options.start(driver)))
                    .orElseGet(() -> new Software(LOCALIZER, "odometry", Value.Mapping.empty(first.location()))));
            if (navigation.avoiding().isPresent() || navigation.planning().isPresent()) {
                devices.add(new Software(NAVIGATOR, "navigator", navigator(navigation)));
            }
            software.put(first, devices);
        });
        return software;
    }

    private Value.Mapping navigator(Navigation navigation) {
        Value.Mapping planned = navigation
                .planning()
                .map(options::settings)
                .orElseGet(() ->
                        Value.Mapping.empty(navigation.avoiding().orElseThrow().location()));
        return navigation
                .avoiding()
                .map(driver -> avoiding(driver).merge(planned))
                .orElse(planned);
    }

    /// Of what a driver is set to, the navigator takes what each has; the rest belongs to its controller.
    private Value.Mapping avoiding(Driver driver) {
        Value.Mapping settings = options.settings(driver);
        Value.Mapping own = settings;
        Value.Mapping controllers = settings;
        for (String name : settings.entries().keySet()) {
            if (Options.OF_NAVIGATORS.contains(name)) {
                controllers = controllers.without(name);
            } else {
                own = own.without(name);
            }
        }
        Location at = driver.location();
        var type = Map.<String, Value>of("type", new Value.Scalar(at, driver.name()));
        Value.Mapping group = controllers.merge(new Value.Mapping(at, type, Map.of("type", at)));
        return own.merge(new Value.Mapping(at, Map.of(CONTROLLER, group), Map.of(CONTROLLER, at)));
    }

    private Optional<StageModel> model(Driver driver) {
        boolean plain = driver.provides().stream().allMatch(a -> a.type().equals(Interfaces.SIMULATION));
        Optional<Driver.Option> option = driver.option("model");
        if (option.isEmpty()) {
            if (!plain) {
                findings.error(
                        driver.location(),
                        "This 'stage' does not say which 'model' it serves.",
                        "Write model \"NAME\", with a model of the world.");
            }
            return Optional.empty();
        }
        Optional<String> name = ConfigReader.text(option.get().value());
        Optional<StageModel> model = name.map(models::get);
        if (model.isEmpty()) {
            findings.error(
                    option.get().value().location(),
                    "There is no model %s in '%s'."
                            .formatted(
                                    WorldProblems.shortened(option.get().value().describe()),
                                    WorldProblems.shortened(world.title())),
                    name.map(this::remedy).orElse("Write model \"NAME\"."));
        }
        return model;
    }

    private String remedy(String read) {
        String some = world.models().stream()
                .map(StageModel::name)
                .limit(MOST_NAMED)
                .map(WorldProblems::shortened)
                .collect(Collectors.joining(", "));
        return findings.maybe(
                read,
                models.keySet(),
                "It has %s%s.".formatted(some, world.models().size() > MOST_NAMED ? ", …" : ""));
    }

    /// Each interface serves the first model of its type, at or below the base, that no other of the driver does.
    ///
    /// @return the robot that they are part of
    private Optional<String> serve(Driver driver, StageModel base) {
        Set<String> used = new HashSet<>();
        for (DriverAddress address : driver.provides()) {
            String type = Interfaces.MODELS.get(address.type());
            Optional<StageModel> model = type == null ? Optional.empty() : use(base, type, used);
            if (type != null && model.isEmpty()) {
                findings.error(
                        address.location(),
                        "'%s' has no model of type '%s'%s for '%s'."
                                .formatted(
                                        WorldProblems.shortened(base.name()),
                                        type,
                                        use(base, type, new HashSet<>()).isPresent() ? " left" : "",
                                        address.device()),
                        "Add one to it in the world, or remove the interface.");
            }
            model.flatMap(found -> Optional.ofNullable(parts.get(found.name())))
                    .ifPresent(part -> part.device()
                            .ifPresent(device -> provide(address, new Source(Optional.of(part.robot()), device))));
            boolean made =
                    sources.containsKey(address.place()) || address.type().equals(Interfaces.SIMULATION);
            if (parts.containsKey(base.name()) && (type == null || model.isPresent()) && !made) {
                findings.warn(
                        address.location(),
                        "'%s' has no effect: robots here have nothing like it.".formatted(address.device()),
                        "");
            }
        }
        Optional<String> robot = Optional.ofNullable(parts.get(base.name())).map(Part::robot);
        if (robot.isEmpty()) {
            findings.warn(
                    driver.location(),
                    "'%s' is part of no robot; it has no devices in a run."
                            .formatted(WorldProblems.shortened(base.name())),
                    "");
        }
        return robot;
    }

    private static Optional<StageModel> use(StageModel model, String type, Set<String> used) {
        if (type.equals(Interfaces.typeOf(model.traits().kind())) && used.add(model.name())) {
            return Optional.of(model);
        }
        return model.children().stream()
                .flatMap(child -> use(child, type, used).stream())
                .findFirst();
    }
}
