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
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.agent.message.NewGoal;
import rsal.data.OccupancyGrid;
import rsal.device.Device;
import rsal.device.RangeSensor;
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
import rsal.scenario.installed.PluginReader;
import rsal.scenario.installed.UntrustedType;
import rsal.scene.Entity;
import rsal.scene.Scene;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;
import rsal.system.RobotSystem;
import rsal.system.RobotSystemProvider.InvalidRobots;
import rsal.time.LockstepScheduler;
import rsal.yaml.Yaml;

/// Reads a scenario with one configuration and its arguments filled in. Goes on after a mistake as far as that
/// makes sense, so that all of them are reported together.
final class PlanReader {
    private static final String INSTEAD = "wander";
    private static final Duration DEFAULT_STEP = Duration.ofMillis(100);

    private final Scenario scenario;
    private final RunOptions options;
    private final Catalog catalog;
    private final Problems problems = new Problems();

    PlanReader(Scenario scenario, RunOptions options, Catalog catalog) {
        this.scenario = scenario;
        this.options = options;
        this.catalog = catalog;
    }

    /// @throws InvalidSettings with all mistakes
    RunPlan read() {
        String configuration = configuration();
        Value.Mapping over = scenario.overlay(configuration);
        checkOverlay(over);
        Map<String, Object> arguments = arguments(configuration, over);
        checkOptions();
        Value.Mapping merged = chosen(scenario.settings(configuration));
        Value.Mapping body =
                ArgumentReader.replace(merged.without("arguments"), scenario.arguments(), arguments, problems);
        var root = new Section("", body, problems, new PluginReader(catalog, scenario.files()));
        for (String read : List.of("rsal", "scenario", "title", "description", "arguments", "configurations")) {
            root.has(read); // by Scenario
        }

        Section run = root.section("run");
        long seed = options.seed().orElse((Long) run.value(Format.SEED).orElse(1L));
        boolean toleratesFailedAgents =
                run.value(Format.FAILED_AGENTS).filter("tolerate"::equals).isPresent();
        var seeds = new Seeds(seed);
        Section clockSection = run.section("clock");
        Clock clock = "wall".equals(clockSection.value(Format.MODE).orElse("")) ? Clock.WALL : Clock.SIMULATED;
        double written = speed(clockSection);
        double speed = options.speed().orElse(written);
        clockSection.done();

        var worldReader = new WorldReader(catalog, scenario.files(), seeds, problems);
        World world = worldReader.read(root.section("world"));
        Optional<Duration> worldStep = world.scene().flatMap(Scene::step);
        var systems = new SystemReader(root.section(SystemReader.KEY), catalog, clock, seeds, worldStep);
        Optional<Mrs> mrs = systems.scenarios();
        Optional<Mas> mas = mas(root.section("mas"), clock);

        Optional<OccupancyGrid> map = world.scene().map(Scene::map);
        var robotReader = new RobotReader(catalog, systems, scenario.files(), map, seeds, problems);
        List<RobotSpec> brought = world.scene().map(Scene::robots).orElse(List.of());
        List<Role> roles = new ArrayList<>();
        if (world.scene().isPresent() && mrs.isPresent()) {
            roles.addAll(worldReader.roles(world.scene().get(), root.section("world"), mrs.get()));
        }
        boolean mayHaveRobots = root.section("world").mapping().find("file").isPresent();
        if (world.scene().isPresent() || root.has("robots") || !mayHaveRobots) {
            roles.addAll(robotReader.read(root.section("robots"), brought, !scenario.isWorld()));
        }
        List<PlannedRobot> bare =
                roles.stream().flatMap(role -> role.robots().stream()).toList();
        var names = new RobotNames(roles, mayHaveRobots && (world.scene().isEmpty() || mrs.isEmpty()));
        Set<String> inWorld = world.scene().stream()
                .flatMap(scene -> scene.things().stream())
                .map(Entity::name)
                .collect(Collectors.toSet());
        List<PlannedThings> things =
                new ThingReader(names, map, inWorld, robotReader.taken(), seeds, problems).read(root.section("things"));
        checkMarkers(roles, things, root.locationOf("things"));
        int before = problems.all().size();
        List<PlannedAgent> agents = new ArrayList<>(agents(root.section("agents"), mas, names, seeds));
        Optional<Joined> joined = new JoinReader(scenario, catalog, problems).read(root);
        joined.ifPresent(other -> agents.addAll(joining(other, agents, mas, names, world.name(), seeds)));
        if (scenario.isWorld()) {
            agents.addAll(instead(bare, world, seeds));
        }
        List<PlannedRobot> robots = equipped(bare, agents);

        Optional<Communication> communication = CommunicationReader.read(root, seeds);
        var faultReader = new FaultReader(names, robots, agents, problems.all().size() == before, seeds, problems);
        List<PlannedFault> faults = faultReader.read(root);

        List<Place> places = PlaceReader.read(root.section("places"));
        var metricReader = new MetricReader(catalog, scenario.files(), names, problems);
        List<PlannedMetric> metrics = metricReader.read(root);
        var goals = new GoalReader(names, things, places, metricReader.words(metrics), problems);
        List<RunPlan.Stop> stops = new ArrayList<>(goals.stops(run));
        if (scenario.isWorld()) {
            world.scene().flatMap(Scene::end).map(PlanReader::after).ifPresent(stops::add);
        }
        run.done();
        List<RunPlan.Measured> measures = scenario.isWorld() ? GoalReader.OF_WORLDS : goals.measures(root);
        root.done();

        if (world.scene().isPresent() && mrs.isPresent() && roles.stream().allMatch(Role::complete)) {
            checkRobots(world.scene().get(), mrs.get(), robots, roles, faultReader, root.locationOf("things"), things);
        }
        problems.throwIfAny();
        return new RunPlan(
                scenario,
                configuration,
                options,
                arguments,
                seed,
                world.name(),
                world.scene().orElseThrow(),
                mrs.orElseThrow(),
                mas.orElseThrow(),
                clock,
                robots,
                things,
                places,
                agents,
                joined.map(Joined::name),
                communication,
                faults,
                speed,
                step(mrs.get(), robots),
                stops,
                toleratesFailedAgents,
                metrics,
                measures);
    }

    private String configuration() {
        List<String> known =
                scenario.configurations().stream().map(Configuration::name).toList();
        String asked = options.configuration().orElse(known.getFirst());
        if (!known.contains(asked)) {
            throw new InvalidSettings(
                    Location.of(scenario.name() + ":" + asked),
                    "Scenario (%s) has no configuration (%s).".formatted(scenario.name(), asked),
                    Suggestion.among(asked, known));
        }
        return asked;
    }

    private void checkOptions() {
        options.speed().stream()
                .filter(speed -> !(speed > 0))
                .forEach(speed -> problems.add(
                        Location.of("--speed " + speed),
                        "A speed must be positive, not (%s).".formatted(speed),
                        "Maybe (max)?"));
        options.limit()
                .filter(limit -> !limit.isPositive())
                .ifPresent(limit ->
                        problems.add(Location.of("--for " + limit.toSeconds()), "A time limit must be positive.", ""));
    }

    /// What says what the whole scenario is can't differ between its configurations.
    private void checkOverlay(Value.Mapping overlay) {
        for (String key : List.of("rsal", "scenario", "description", "arguments", "configurations")) {
            if (overlay.find(key).isPresent()) {
                problems.add(
                        overlay.keys().getOrDefault(key, overlay.location()),
                        "(%s) can't be changed by a configuration.".formatted(key),
                        key.equals("arguments") ? "Maybe (args), which sets the values of arguments." : "");
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
        values.putAll(ArgumentReader.overridden(declared, section.section("args")));
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

    /// Agents that drive robots instead of the programs that the world names.
    private List<PlannedAgent> instead(List<PlannedRobot> robots, World world, Seeds seeds) {
        Optional<AgentType> type = Optional.ofNullable(catalog.agents().get(INSTEAD));
        Map<String, String> programs = world.scene().map(Scene::programs).orElse(Map.of());
        return robots.stream()
                .filter(robot -> type.isPresent() && robot.spares().pilot().isPossible())
                .filter(robot -> programs.containsKey(robot.spec().id()))
                .map(robot -> robot.spec().id())
                .map(id -> new PlannedAgent(
                        id,
                        INSTEAD,
                        type.orElseThrow(),
                        Arguments.defaults(type.orElseThrow().parameters()),
                        Optional.of(id),
                        seeds.of("agent/" + id)))
                .toList();
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

    private List<PlannedAgent> agents(Section section, Optional<Mas> mas, RobotNames robots, Seeds seeds) {
        var agents = new ArrayList<PlannedAgent>();
        var names = new HashSet<String>();
        var drivers = new HashMap<String, String>(); // agents by the robot that they drive
        for (String role : section.names()) {
            Section agent = section.section(role);
            if (!isName(role)) {
                agent.problem(agent.location(), "(%s) can't be the name of an agent.".formatted(role), "");
            }
            List<PlannedAgent> each = agents(role, agent, mas, robots, seeds);
            for (PlannedAgent planned : each) {
                if (!names.add(planned.name())) {
                    agent.problem(
                            agent.location(),
                            "There are two agents (%s).".formatted(planned.name()),
                            "Rename one of them.");
                }
                checkName(planned.name(), agents, mas, agent.location());
                agents.add(planned);
            }
            boolean yields = (Boolean) agent.value(Format.YIELDS).orElse(false);
            agent.done();
            checkDrivers(each, yields, drivers, agent.location());
        }
        section.done();
        checkNumber(agents.size(), section.location());
        return agents;
    }

    /// Agents of a scenario that joins this one.
    private List<PlannedAgent> joining(
            Joined other, List<PlannedAgent> own, Optional<Mas> mas, RobotNames robots, String map, Seeds seeds) {
        other.checkRoles(robots, problems);
        var agents = new ArrayList<PlannedAgent>();
        var section = new Section("agents", other.agents(), problems);
        for (String name : section.names()) {
            Section agent = section.section(name);
            Optional<AgentType> type = type(agent, mas, other.files());
            Section args = agent.section("args");
            agent.done();
            if (own.stream().anyMatch(one -> one.name().equals(name))) {
                problems.add(
                        other.at(),
                        "There is an agent (%s) here and in scenario (%s).".formatted(name, other.name()),
                        "Rename the one here.");
            }
            checkName(name, own, mas, other.at());
            if (type.isEmpty()) {
                continue;
            }
            Optional<Arguments> given = args.arguments(type.get().parameters());
            checkNeeds(agent, new Needs(type.get(), given), Optional.empty());
            given.ifPresent(read -> {
                other.checkPlaces(name, type.get(), read, map, problems);
                Arguments arguments = other.here(type.get(), read, robots, problems);
                agents.add(new PlannedAgent(
                        name, name, type.get(), arguments, Optional.empty(), seeds.of("agent/" + name)));
            });
        }
        checkNumber(own.size() + agents.size(), other.at());
        return agents;
    }

    /// One that is installed, or that its author wrote in a language of the host.
    ///
    /// @param mas empty when it can't be read
    /// @param files of the scenario that names it
    private Optional<AgentType> type(Section agent, Optional<Mas> mas, FileSource files) {
        String key = agent.text("type");
        if (key.isEmpty()) {
            return Optional.empty();
        }
        Location at = agent.locationOf("type");
        List<String> hosts = catalog.hostsOf(key);
        if (hosts.isEmpty()) {
            return catalog.agent(key, at, problems);
        }
        return mas.flatMap(host -> written(agent, host, hosts, files));
    }

    private Optional<AgentType> written(Section agent, Mas mas, List<String> hosts, FileSource files) {
        String file = agent.text("type");
        Location at = agent.locationOf("type");
        Optional<AgentLanguage> language = catalog.language(mas.provider(), file);
        if (language.isEmpty()) {
            problems.add(
                    at,
                    "Multi-agent system (%s) can't run (%s)."
                            .formatted(mas.provider().key(), file),
                    "Maybe mas: {use: %s}.".formatted(hosts.getFirst()));
            return Optional.empty();
        }
        if (language.get().runsCode() && !files.isTrusted()) {
            files.read(file, Yaml.MAX_CHARACTERS, at); // it must be there
            return Optional.of(UntrustedType.of(file, agent.section("args")));
        }
        try {
            return Optional.of(language.get().read(file, files, at));
        } catch (InvalidSettings e) {
            problems.addAll(e);
            return Optional.empty();
        }
    }

    /// Two agents that drive one robot take it from each other again and again, and both get nowhere.
    ///
    /// @param drivers those before, by their robots; those of these are added
    private void checkDrivers(List<PlannedAgent> agents, boolean yields, Map<String, String> drivers, Location at) {
        boolean told = false;
        for (PlannedAgent agent : agents) {
            if (yields || agent.type().yields() || !agent.type().drives(agent.arguments())) {
                continue;
            }
            String other = agent.robot()
                    .map(robot -> drivers.putIfAbsent(robot, agent.name()))
                    .orElse(null);
            if (other != null && !told) { // one of a team says it all
                told = true;
                problems.add(
                        at,
                        "Agents '%s' and '%s' both drive robot '%s': each would take it from the other."
                                .formatted(other, agent.name(), agent.robot().orElseThrow()),
                        "Leave one out, or give it another robot. 'yields: true' says of one that it leaves the robot to"
                                + " the other as long as that drives it.");
            }
        }
    }

    /// A language may have other uses for a name, and a multi-agent system too.
    private void checkName(String agent, List<PlannedAgent> others, Optional<Mas> mas, Location at) {
        mas.map(Mas::provider)
                .flatMap(host -> host.nameProblem(
                        agent, others.stream().map(PlannedAgent::name).toList()))
                .ifPresent(why ->
                        problems.add(at, "No agent can be called '%s' here. %s".formatted(agent, why), "Rename it."));
        mas.map(Mas::provider)
                .filter(host -> catalog.languages(host)
                        .anyMatch(language -> language.takenNames().contains(agent)))
                .ifPresent(host -> problems.add(
                        at,
                        "No agent can be called (%s) on multi-agent system (%s): its language has another use for that name."
                                .formatted(agent, host.key()),
                        "Rename it."));
    }

    private void checkNumber(int agents, Location at) {
        if (agents > Format.MAX_AGENTS) {
            problems.add(at, "There are %d agents; at most %d can be.".formatted(agents, Format.MAX_AGENTS), "");
        }
    }

    private List<PlannedAgent> agents(String name, Section section, Optional<Mas> mas, RobotNames robots, Seeds seeds) {
        Optional<AgentType> type = type(section, mas, scenario.files());
        Optional<Role> role = robotRole(section, robots);
        Section args = section.section("args");
        if (type.isEmpty()) {
            return List.of();
        }
        Optional<Arguments> arguments = args.arguments(type.get().parameters());
        checkNeeds(section, new Needs(type.get(), arguments), role);
        if (arguments.isEmpty()) {
            return List.of();
        }
        robots.check(args, type.get().parameters(), arguments.get());
        if (role.isEmpty()) {
            return List.of(new PlannedAgent(
                    name, name, type.get(), arguments.get(), Optional.empty(), seeds.of("agent/" + name)));
        }
        return role.get().robots().stream()
                .map(robot -> robot.spec().id())
                .map(id -> {
                    String own = id.startsWith(role.get().name())
                            ? name + id.substring(role.get().name().length()) // hunter-2 → follow-2
                            : name + "-" + id;
                    return new PlannedAgent(
                            own, name, type.get(), arguments.get(), Optional.of(id), seeds.of("agent/" + own));
                })
                .toList();
    }

    private Optional<Role> robotRole(Section section, RobotNames robots) {
        if (!section.has("robot")) {
            return Optional.empty();
        }
        String name = section.text("robot");
        Optional<Role> role = robots.role(name);
        if (role.isEmpty() && !name.isEmpty() && !robots.open()) {
            section.problem(
                    "robot",
                    "No robots have the role (%s).".formatted(name),
                    Suggestion.among(
                            name, robots.roles().stream().map(Role::name).toList()));
        }
        return role;
    }

    private static void checkNeeds(Section section, Needs needs, Optional<Role> role) {
        if (role.isEmpty()) {
            if (!needs.all().isEmpty() && !section.has("robot")) {
                section.problem(
                        "type",
                        "%s needs a robot with %s."
                                .formatted(needs.whose(needs.all()), DeviceReader.words(needs.all())),
                        "Add a line (robot: ROLE).");
            }
            return;
        }
        var missing = role.get().missing(needs.all());
        if (role.get().complete() && !missing.isEmpty()) {
            section.problem(
                    "robot",
                    "%s needs a robot with %s, which robots of role (%s) don't have."
                            .formatted(
                                    needs.whose(missing),
                                    DeviceReader.words(missing),
                                    role.get().name()),
                    "Add it to (robots.%s.devices).".formatted(role.get().name()));
        }
    }

    /// Finders of markers must not take one for another.
    private void checkMarkers(List<Role> roles, List<PlannedThings> things, Location atThings) {
        var wearers = new HashMap<Integer, String>();
        for (Role role : roles) {
            for (PlannedRobot robot : role.robots()) {
                robot.spec()
                        .marker()
                        .ifPresent(marker -> note(
                                wearers,
                                marker,
                                robot.spec().id(),
                                role.placeOf(robot.spec().id(), Format.FIDUCIAL.name())));
            }
        }
        for (PlannedThings.PlannedThing thing :
                things.stream().flatMap(group -> group.each().stream()).toList()) {
            thing.thing()
                    .marker()
                    .ifPresent(
                            marker -> note(wearers, marker.id(), thing.thing().name(), atThings));
        }
    }

    private void note(Map<Integer, String> wearers, int marker, String name, Location at) {
        String other = wearers.putIfAbsent(marker, name);
        if (other != null) {
            problems.add(
                    at,
                    "(%s) and (%s) wear the same marker (%d).".formatted(other, name, marker),
                    "Give (fiducial) of one group another number, so that its ids don't meet the other's.");
        }
    }

    /// Lets the robot systems say what they think of their robots, of faults and things, without starting them.
    ///
    /// @param mrs the scenario's
    private void checkRobots(
            Scene scene,
            Mrs mrs,
            List<PlannedRobot> robots,
            List<Role> roles,
            FaultReader faults,
            Location thingsAt,
            List<PlannedThings> things) {
        var simulated = new ArrayList<Mrs>();
        boolean refused = false;
        for (Mrs each : RunPlan.systems(mrs, robots)) {
            try (RobotSystem system = each.provider().create(each.config(scene, robots), new LockstepScheduler())) {
                faults.check(system, each);
                system.simulation().ifPresent(_ -> simulated.add(each));
            } catch (InvalidRobots e) {
                refused = true; // and may simulate or not
                for (InvalidRobots.Problem problem : e.problems()) {
                    problems.add(
                            placeOf(problem.robot(), problem.setting(), roles),
                            "Robot (%s): %s".formatted(problem.robot(), problem.message()),
                            "");
                }
            }
        }
        if (!things.isEmpty() && simulated.isEmpty() && !refused) {
            problems.add(
                    thingsAt,
                    "%s simulates no world that (things) could be put into.".formatted(mrs.name()),
                    "Leave (things) out, or use robot system (sim).");
        }
        if (!refused) {
            checkMixed(robots, simulated, roles);
        }
        simulated.stream().skip(1).forEach(other -> {
            String robot = other.own(robots).getFirst().id();
            problems.add(
                    placeOf(robot, SystemReader.KEY, roles),
                    "Robot (%s) would be in another simulated world than those of %s; a run has one."
                            .formatted(robot, simulated.getFirst().words()),
                    "Give all simulated robots the same (mrs).");
        });
    }

    /// @param simulated systems
    private void checkMixed(List<PlannedRobot> robots, List<Mrs> simulated, List<Role> roles) {
        for (PlannedRobot robot : robots) {
            checkSeeing(robot, simulated, roles);
            String id = robot.spec().id();
            Location at = placeOf(id, Format.PROXY.name(), roles);
            if (robot.proxy() && simulated.contains(robot.mrs())) {
                problems.add(
                        at, "Robot (%s) is simulated itself and has no stand-in.".formatted(id), "Leave (proxy) out.");
            } else if (robot.proxy() && simulated.isEmpty()) {
                problems.add(
                        at,
                        "There is no simulated world for a stand-in of robot (%s).".formatted(id),
                        "Leave (proxy) out, or let the scenario use robot system (sim).");
            }
        }
    }

    private void checkSeeing(PlannedRobot robot, List<Mrs> simulated, List<Role> roles) {
        if (!robot.overlay()) {
            return;
        }
        String id = robot.spec().id();
        Location at = placeOf(id, Format.OVERLAY.name(), roles);
        if (simulated.contains(robot.mrs())) {
            problems.add(
                    at, "Robot (%s) is simulated itself and sees its world.".formatted(id), "Leave (overlay) out.");
        } else if (simulated.isEmpty()) {
            problems.add(
                    at,
                    "There is no simulated world that robot (%s) could see.".formatted(id),
                    "Leave (overlay) out, or let the scenario use robot system (sim).");
        } else if (!DeviceSelector.has(robot.spec().model(), RangeSensor.class)) {
            problems.add(
                    at,
                    "Robot (%s) has no laser and no sonars by which it could see what is simulated.".formatted(id),
                    "Add one to its (devices), or leave (overlay) out.");
        }
    }

    private Location placeOf(String robot, String setting, List<Role> roles) {
        return roles.stream()
                .filter(role -> role.has(robot))
                .findFirst()
                .map(role -> role.placeOf(robot, setting))
                .orElse(scenario.location());
    }

    /// Robots and agents can't be called what means something else.
    static boolean isName(String text) {
        return Format.NAME.matcher(text).matches() && !text.equals(NewGoal.ALL) && !text.equals("operator");
    }
}
