package rsal.scenario;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;
import rsal.agent.AgentLanguage;
import rsal.agent.AgentType;
import rsal.scenario.RobotReader.Role;
import rsal.scenario.RunPlan.Mas;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.RunPlan.PlannedRobot;
import rsal.scenario.installed.Catalog;
import rsal.scenario.installed.UnavailableType;
import rsal.scenario.installed.UntrustedType;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.InvalidSettings;
import rsal.settings.Location;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.yaml.Yaml;

/// Reads which agents there are, and checks that each has what it needs.
final class AgentReader {
    private static final String INSTEAD = "wander";

    private final Catalog catalog;
    private final FileSource files;
    private final Optional<Mas> mas;
    private final RobotNames robots;
    private final Seeds seeds;
    private final Problems problems;
    private final Set<AgentLanguage> languages = new LinkedHashSet<>(); // that the scenario uses
    private final Map<String, Location> named = new HashMap<>(); // agents, by their names

    /// @param files of the scenario
    /// @param mas empty when it can't be read
    AgentReader(
            Catalog catalog, FileSource files, Optional<Mas> mas, RobotNames robots, Seeds seeds, Problems problems) {
        this.catalog = catalog;
        this.files = files;
        this.mas = mas;
        this.robots = robots;
        this.seeds = seeds;
        this.problems = problems;
    }

    List<PlannedAgent> read(Section section) {
        var agents = new ArrayList<PlannedAgent>();
        var names = new HashSet<String>();
        var drivers = new HashMap<String, String>(); // agents by the robot that they drive
        for (String role : section.names()) {
            Section agent = section.section(role);
            if (!PlanReader.isName(role)) {
                agent.problem(agent.location(), "'%s' can't be the name of an agent.".formatted(role), "");
            }
            List<PlannedAgent> each = agents(role, agent);
            for (PlannedAgent planned : each) {
                if (!names.add(planned.name())) {
                    agent.problem(
                            agent.location(),
                            "There are two agents '%s'.".formatted(planned.name()),
                            "Rename one of them.");
                }
                checkName(planned.name(), agents, agent.location());
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
    List<PlannedAgent> joining(Joined other, List<PlannedAgent> own, String map) {
        other.checkRoles(robots, problems);
        var agents = new ArrayList<PlannedAgent>();
        var section = new Section("agents", other.agents(), problems);
        for (String name : section.names()) {
            Section agent = section.section(name);
            Optional<AgentType> type = type(agent, other.files());
            Section args = agent.section(Format.PARAMETERS);
            agent.done();
            if (own.stream().anyMatch(one -> one.name().equals(name))) {
                problems.add(
                        other.at(),
                        "There is an agent '%s' here and in scenario '%s'.".formatted(name, other.name()),
                        "Rename the one here.");
            }
            checkName(name, own, other.at());
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

    /// Agents that wait for tasks of an agent that is not there would wait for ever. Those in files may give tasks,
    /// too.
    void checkPartners(List<PlannedAgent> all, Location at) {
        Set<String> types = all.stream().map(agent -> agent.type().key()).collect(Collectors.toSet());
        if (!catalog.agents().keySet().containsAll(types)) {
            return;
        }
        var reported = new HashSet<String>();
        for (PlannedAgent agent : all) {
            agent.type()
                    .needsAgent(agent.arguments())
                    .filter(key -> !types.contains(key) && reported.add(agent.role()))
                    .ifPresent(key -> problems.add(
                            at,
                            "Agent '%s' of type '%s' waits for tasks of an agent of type '%s', and there is none."
                                    .formatted(agent.role(), agent.type().key(), key),
                            "Add one (%s: {type: %s}), or change the parameters of '%s'."
                                    .formatted(key, key, agent.role())));
        }
    }

    /// Agents that drive robots instead of the programs that the world names.
    List<PlannedAgent> instead(List<PlannedRobot> all, Map<String, String> programs) {
        Optional<AgentType> type = Optional.ofNullable(catalog.agents().get(INSTEAD));
        return all.stream()
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

    private List<PlannedAgent> agents(String name, Section section) {
        Optional<AgentType> type = type(section, files);
        Optional<Role> role = robotRole(section);
        Section args = section.section(Format.PARAMETERS);
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

    /// One that is installed, or that its author wrote in a file.
    ///
    /// @param files of the scenario that names it
    private Optional<AgentType> type(Section agent, FileSource files) {
        String key = agent.text("type");
        if (key.isEmpty()) {
            return Optional.empty();
        }
        Location at = agent.locationOf("type");
        Optional<AgentLanguage> language = catalog.language(key);
        return language.isEmpty() ? catalog.agent(key, at, problems) : written(agent, language.get(), files);
    }

    private Optional<AgentType> written(Section agent, AgentLanguage language, FileSource files) {
        String file = agent.text("type");
        Location at = agent.locationOf("type");
        languages.add(language);
        if (language.runsCode() && !files.isTrusted()) {
            language.file(file).ifPresent(path -> files.read(path, Yaml.MAX_CHARACTERS, at)); // it must be there
            return Optional.of(UntrustedType.of(file, agent.section(Format.PARAMETERS)));
        }
        Optional<String> unavailable = language.unavailable();
        if (unavailable.isPresent()) {
            language.file(file).ifPresent(path -> files.read(path, Yaml.MAX_CHARACTERS, at)); // it must be there
            return Optional.of(UnavailableType.of(file, agent.section(Format.PARAMETERS), at, unavailable.get()));
        }
        try {
            return Optional.of(language.read(file, files, at));
        } catch (InvalidSettings e) {
            problems.addAll(e.beside(at));
            return Optional.empty();
        }
    }

    /// Two agents that drive one robot take it from each other again and again, and both get nowhere.
    ///
    /// @param drivers those before, by their robots; those of these are added
    private void checkDrivers(List<PlannedAgent> agents, boolean yields, Map<String, String> drivers, Location at) {
        boolean reported = false;
        for (PlannedAgent agent : agents) {
            if (yields || agent.type().yields() || !agent.type().drives(agent.arguments())) {
                continue;
            }
            String other = agent.robot()
                    .map(robot -> drivers.putIfAbsent(robot, agent.name()))
                    .orElse(null);
            if (other != null && !reported) { // one of a team says it all
                reported = true;
                problems.add(
                        at,
                        "Agents '%s' and '%s' both drive robot '%s': each would take it from the other."
                                .formatted(other, agent.name(), agent.robot().orElseThrow()),
                        "Remove one, or give it another robot. 'yields: true' says of one that it leaves the robot to"
                                + " the other as long as that drives it.");
            }
        }
    }

    /// A multi-agent system may have other uses for a name.
    private void checkName(String agent, List<PlannedAgent> others, Location at) {
        mas.map(Mas::provider)
                .flatMap(host -> host.nameProblem(
                        agent, others.stream().map(PlannedAgent::name).toList()))
                .ifPresent(why ->
                        problems.add(at, "No agent can be called '%s' here. %s".formatted(agent, why), "Rename it."));
        named.putIfAbsent(agent, at);
    }

    /// A language that some agent of the scenario is written in may have other uses for a name.
    void checkTakenNames() {
        for (AgentLanguage language : languages) {
            for (String name : new TreeSet<>(language.takenNames())) {
                Location at = named.get(name);
                if (at != null) {
                    problems.add(
                            at,
                            "No agent can be called '%s' beside agents in files '*%s': their language has another use for that name."
                                    .formatted(name, language.suffix()),
                            "Rename it.");
                }
            }
        }
    }

    private void checkNumber(int agents, Location at) {
        if (agents > Format.MAX_AGENTS) {
            problems.add(at, "There are %d agents; at most %d can be.".formatted(agents, Format.MAX_AGENTS), "");
        }
    }

    private Optional<Role> robotRole(Section section) {
        if (!section.has("robot")) {
            return Optional.empty();
        }
        String name = section.text("robot");
        Optional<Role> role = robots.role(name);
        if (role.isEmpty() && !name.isEmpty() && !robots.open()) {
            section.problem(
                    "robot",
                    "No robots have the role '%s'.".formatted(name),
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
                    "%s needs a robot with %s, which robots of role '%s' don't have."
                            .formatted(
                                    needs.whose(missing),
                                    DeviceReader.words(missing),
                                    role.get().name()),
                    "Add it to 'robots.%s.devices'.".formatted(role.get().name()));
        }
    }
}
