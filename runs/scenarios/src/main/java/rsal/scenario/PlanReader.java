package rsal.scenario;

import java.math.BigDecimal;
import java.time.Duration;
import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import rsal.agent.AgentHostProvider;
import rsal.agent.message.NewGoal;
import rsal.data.OccupancyGrid;
import rsal.device.Device;
import rsal.map.KnownMaps;
import rsal.map.Maps;
import rsal.robot.RobotSpec;
import rsal.scenario.RobotReader.Role;
import rsal.scenario.RunPlan.Clock;
import rsal.scenario.RunPlan.Mas;
import rsal.scenario.RunPlan.Mrs;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.WorldReader.World;
import rsal.scenario.condition.Grammar;
import rsal.scenario.fault.PlannedFault;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.Installation;
import rsal.scenario.installed.MapFacts;
import rsal.scenario.installed.PluginReader;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// Reads a scenario with one configuration and its arguments filled in. Goes on after an error as far as that
/// makes sense, so that all of them are reported together.
final class PlanReader {
    private static final Duration DEFAULT_STEP = Duration.ofMillis(100);

    private final Scenario scenario;
    private final RunOptions options;
    private final Catalog catalog;
    private final KnownMaps maps;
    private final MapFacts mapFacts;
    private final Problems problems = new Problems();

    PlanReader(Scenario scenario, RunOptions options, Installation installation) {
        this.scenario = scenario;
        this.options = options;
        this.catalog = installation.catalog();
        this.maps = installation.maps();
        this.mapFacts = installation.mapFacts();
    }

    /// The run's own settings.
    ///
    /// @param speed simulated over real time
    private record RunSettings(long seed, boolean toleratesFailedAgents, Clock clock, double speed) {}

    /// What agents find.
    ///
    /// @param mrs empty when it can't be read, as `mas`
    /// @param roles with robots that lack what their agents need
    private record Surroundings(
            World world,
            Optional<Mrs> mrs,
            Optional<Mas> mas,
            List<Role> roles,
            RobotNames names,
            List<PlannedThings> things,
            RobotChecker checker) {
        Optional<Scene> scene() {
            return world.scene();
        }

        List<PlannedRobot> robots() {
            return roles.stream().flatMap(role -> role.robots().stream()).toList();
        }
    }

    /// @param robots with what their agents need
    private record Team(List<PlannedAgent> agents, Optional<Joined> joined, List<PlannedRobot> robots) {}

    /// What a run is judged by.
    private record Judgment(
            List<Place> places,
            List<PlannedMetric> metricTypes,
            List<RunPlan.Stop> stops,
            List<RunPlan.MetricDefinition> metrics) {}

    /// @throws InvalidSettings with all errors
    RunPlan read() {
        String configuration = configuration();
        Value.Mapping over = scenario.overlay(configuration);
        checkOverlay(over);
        Map<String, Object> arguments = arguments(configuration, over);
        checkOptions();
        Section root = root(configuration, arguments);
        Section run = root.section("run");
        RunSettings settings = runSettings(run);
        var seeds = new Seeds(settings.seed());
        Surroundings found = surroundings(root, settings.clock(), seeds);
        int before = problems.all().size();
        Team team = team(root, found, seeds);
        Optional<Communication> communication = CommunicationReader.read(root, seeds);
        boolean mayCheck = problems.all().size() == before;
        var faultReader = new FaultReader(found.names(), team.robots(), team.agents(), mayCheck, seeds, problems);
        List<PlannedFault> faults = faultReader.read(root);
        Judgment judgment = judgment(root, run, found);
        run.done();
        root.done();
        if (found.mrs().isPresent() && found.mas().isPresent()) {
            new DrivenTimeChecker(root.locationOf(SystemReader.KEY), problems)
                    .check(
                            RunPlan.systems(found.mrs().get(), found.robots()),
                            found.mas().get());
        }
        if (found.scene().isPresent()
                && found.mrs().isPresent()
                && found.roles().stream().allMatch(Role::complete)) {
            found.checker()
                    .checkRobots(
                            found.scene().get(),
                            found.mrs().get(),
                            team.robots(),
                            faultReader,
                            root.locationOf("things"),
                            found.things());
        }
        problems.throwIfAny();
        return new RunPlan(
                scenario,
                configuration,
                options,
                arguments,
                settings.seed(),
                found.world().name(),
                found.scene().orElseThrow(),
                found.mrs().orElseThrow(),
                found.mas().orElseThrow(),
                settings.clock(),
                team.robots(),
                found.things(),
                judgment.places(),
                team.agents(),
                team.joined().map(Joined::name),
                communication,
                faults,
                settings.speed(),
                step(found.mrs().get(), team.robots()),
                judgment.stops(),
                settings.toleratesFailedAgents(),
                judgment.metricTypes(),
                judgment.metrics());
    }

    /// All settings of a configuration, with the values of arguments and what the options say.
    private Section root(String configuration, Map<String, Object> arguments) {
        Value.Mapping merged = chosen(scenario.settings(configuration));
        Value.Mapping body =
                ArgumentReader.replace(merged.without("arguments"), scenario.arguments(), arguments, problems);
        var root = new Section("", body, problems, new PluginReader(catalog, scenario.files()));
        for (String read : List.of("rsal", "scenario", "title", "description", "arguments", "configurations")) {
            root.has(read); // by Scenario
        }
        return root;
    }

    private RunSettings runSettings(Section run) {
        long seed = options.seed().orElse((Long) run.value(Format.SEED).orElse(1L));
        boolean toleratesFailedAgents =
                run.value(Format.FAILED_AGENTS).filter("tolerate"::equals).isPresent();
        Section clockSection = run.section("clock");
        Clock clock = "wall".equals(clockSection.value(Format.MODE).orElse("")) ? Clock.WALL : Clock.SIMULATED;
        double written = speed(clockSection);
        clockSection.done();
        return new RunSettings(
                seed, toleratesFailedAgents, clock, options.speed().orElse(written));
    }

    private Surroundings surroundings(Section root, Clock clock, Seeds seeds) {
        Section worldSection = root.section("world");
        var worldReader =
                new WorldReader(catalog, new Maps(scenario.files(), maps), mapFacts, scenario.files(), seeds, problems);
        World world = worldReader.read(worldSection);
        Optional<Duration> worldStep = world.scene().flatMap(Scene::step);
        var systems = new SystemReader(root.section(SystemReader.KEY), catalog, clock, seeds, worldStep);
        Optional<Mrs> mrs = systems.scenarios();
        Optional<Mas> mas = mas(root.section("mas"), clock);

        Optional<OccupancyGrid> map = world.scene().map(Scene::map);
        var robotReader = new RobotReader(catalog, systems, scenario.files(), map, mapFacts, seeds, problems);
        List<RobotSpec> brought = world.scene().map(Scene::robots).orElse(List.of());
        List<Role> roles = new ArrayList<>();
        if (world.scene().isPresent() && mrs.isPresent()) {
            roles.addAll(worldReader.roles(world.scene().get(), worldSection, mrs.get()));
        }
        boolean mayHaveRobots = worldSection.mapping().find("file").isPresent();
        if (world.scene().isPresent() || root.has("robots") || !mayHaveRobots) {
            roles.addAll(robotReader.read(root.section("robots"), brought, !scenario.isWorld()));
        }
        var names = new RobotNames(roles, mayHaveRobots && (world.scene().isEmpty() || mrs.isEmpty()));
        Set<String> inWorld = world.scene().stream()
                .flatMap(scene -> scene.things().stream())
                .map(Entity::name)
                .collect(Collectors.toSet());
        List<PlannedThings> things = new PlannedThingReader(
                        names, map, mapFacts, inWorld, robotReader.taken(), seeds, problems)
                .read(root.section("things"));
        var checker = new RobotChecker(roles, scenario.location(), problems);
        checker.checkMarkers(things, root.locationOf("things"));
        return new Surroundings(world, mrs, mas, roles, names, things, checker);
    }

    private Team team(Section root, Surroundings found, Seeds seeds) {
        var reader = new AgentReader(catalog, scenario.files(), found.mas(), found.names(), seeds, problems);
        List<PlannedAgent> agents = new ArrayList<>(reader.read(root.section("agents")));
        Optional<Joined> joined = new JoinReader(scenario, catalog, problems).read(root);
        joined.ifPresent(other ->
                agents.addAll(reader.joining(other, agents, found.world().name())));
        if (scenario.isWorld()) {
            agents.addAll(reader.instead(
                    found.robots(), found.scene().map(Scene::programs).orElse(Map.of())));
        }
        reader.checkTakenNames();
        reader.checkPartners(agents, root.locationOf("agents"));
        return new Team(agents, joined, equipped(found.robots(), agents));
    }

    private Judgment judgment(Section root, Section run, Surroundings found) {
        List<Place> places = PlaceReader.read(root.section("places"));
        var metricReader = new MetricReader(catalog, scenario.files(), found.names(), problems);
        List<PlannedMetric> metricTypes = metricReader.read(root);
        var goals = new GoalReader(found.names(), found.things(), places, metricReader.words(metricTypes), problems);
        List<RunPlan.Stop> stops = new ArrayList<>(goals.stops(run));
        if (scenario.isWorld()) {
            found.scene().flatMap(Scene::end).map(PlanReader::after).ifPresent(stops::add);
        }
        List<RunPlan.MetricDefinition> metrics = scenario.isWorld() ? GoalReader.OF_WORLDS : goals.metrics(root);
        return new Judgment(places, metricTypes, stops, metrics);
    }

    private String configuration() {
        List<String> known =
                scenario.configurations().stream().map(Configuration::name).toList();
        String asked = options.configuration().orElse(known.getFirst());
        if (!known.contains(asked)) {
            throw new InvalidSettings(
                    Location.of(scenario.name() + ":" + asked),
                    "Scenario '%s' has no configuration '%s'.".formatted(scenario.name(), asked),
                    Suggestion.among(asked, known));
        }
        return asked;
    }

    private void checkOptions() {
        options.speed().stream()
                .filter(speed -> !(speed > 0))
                .forEach(speed -> problems.add(
                        Location.of("--speed " + speed),
                        "A speed must be positive, not '%s'.".formatted(speed),
                        "Maybe 'max'?"));
        options.limit()
                .filter(limit -> !limit.isPositive())
                .ifPresent(limit ->
                        problems.add(Location.of("--for " + limit.toSeconds()), "A time limit must be positive.", ""));
    }

    /// What says what the whole scenario is can't differ between its configurations.
    private void checkOverlay(Value.Mapping overlay) {
        for (String key : List.of("rsal", "scenario", "description", "configurations")) {
            if (overlay.find(key).isPresent()) {
                problems.add(
                        overlay.keys().getOrDefault(key, overlay.location()),
                        "'%s' can't be changed by a configuration.".formatted(key),
                        "");
            }
        }
    }

    /// Settings with what the options name on top: back ends, the clock, and the scenario that joins.
    private Value.Mapping chosen(Value.Mapping settings) {
        Value.Mapping chosen = settings;
        chosen = over(chosen, "--mas", options.mas(), "mas", "use");
        chosen = over(chosen, "--mrs", options.mrs(), "mrs", "use");
        chosen = over(chosen, "--clock", options.clock(), "run", "clock", "mode");
        return over(chosen, "--with", options.with(), JoinReader.KEY);
    }

    /// @param typed what stands in for the value there; empty to leave it
    /// @param path to the value, from the outside
    private static Value.Mapping over(Value.Mapping settings, String option, Optional<String> typed, String... path) {
        if (typed.isEmpty()) {
            return settings;
        }
        var at = Location.of(option + " " + typed.get());
        Value value = new Value.Scalar(at, typed.get());
        for (String key : List.of(path).reversed()) {
            value = new Value.Mapping(at, Map.of(key, value), Map.of(key, at));
        }
        return settings.merge((Value.Mapping) value);
    }

    private Map<String, Object> arguments(String configuration, Value.Mapping overlay) {
        var values = new LinkedHashMap<String, Object>();
        List<Parameter<?>> declared = scenario.arguments();
        declared.forEach(parameter -> parameter.fallback().ifPresent(value -> values.put(parameter.name(), value)));
        var section = new Section("configurations." + configuration, overlay, problems);
        values.putAll(ArgumentReader.overridden(declared, section.section(Format.ARGUMENTS)));
        values.putAll(ArgumentReader.typed(declared, options, problems));
        return values;
    }

    private double speed(Section clock) {
        boolean max = clock.mapping()
                .find("speed")
                .filter(value ->
                        value instanceof Value.Scalar scalar && scalar.value().equals("max"))
                .isPresent();
        if (max) {
            clock.has("speed");
            return Double.POSITIVE_INFINITY;
        }
        return (Double) clock.value(Format.SPEED).orElse(1.0);
    }

    private Optional<Mas> mas(Section section, Clock clock) {
        var kind = new BackEnd.Kind<>(
                "multi-agent system",
                Format.DEFAULT_MAS,
                catalog.hosts(),
                Format.HOSTS_APART,
                AgentHostProvider::followsSchedulerTime,
                AgentHostProvider::parameters);
        return BackEnd.read(kind, section, "", clock).map(chosen -> new Mas(chosen.provider(), chosen.settings()));
    }

    /// That of the first robot system that has one.
    private static Duration step(Mrs mrs, List<PlannedRobot> robots) {
        return RunPlan.systems(mrs, robots).stream()
                .map(Mrs::settings)
                .flatMap(settings -> SystemReader.step(settings).stream())
                .findFirst()
                .orElse(DEFAULT_STEP);
    }

    /// Robots of a world have what their agents need.
    private static List<PlannedRobot> equipped(List<PlannedRobot> robots, List<PlannedAgent> agents) {
        var needs = new HashMap<String, Set<Class<? extends Device>>>();
        for (PlannedAgent agent : agents) {
            agent.robot()
                    .ifPresent(id -> needs.computeIfAbsent(id, _ -> new HashSet<>())
                            .addAll(agent.type().needs(agent.arguments())));
        }
        return robots.stream()
                .map(robot -> DeviceSelector.equipped(
                        robot, needs.getOrDefault(robot.spec().id(), Set.of())))
                .toList();
    }

    private static RunPlan.Stop after(Duration time) {
        return new RunPlan.Stop(
                Grammar.condition(
                        "time >= "
                                + BigDecimal.valueOf(time.toNanos(), 9)
                                        .stripTrailingZeros()
                                        .toPlainString(),
                        Grammar.Names.of(List.of())),
                RunPlan.Outcome.SUCCESS,
                Duration.ZERO);
    }

    /// Robots and agents can't be called what means something else.
    static boolean isName(String text) {
        return Format.NAME.matcher(text).matches() && !text.equals(NewGoal.ALL) && !text.equals("operator");
    }
}
