package rsal.scenario;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import rsal.agent.AgentType;
import rsal.scenario.RobotReader.Role;
import rsal.settings.Arguments;
import rsal.settings.FileSource;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problems;
import rsal.settings.Section;
import rsal.settings.Suggestion;
import rsal.settings.Value;

/// What a scenario that joins another one (`with`) brings along: its agents without a robot.
///
/// @param at where it is joined
/// @param name of the scenario and its configuration (`distribution:found`)
/// @param files where those of its agents are
/// @param agents those without a robot, arguments filled in
/// @param placed for each of them the texts among its settings that stand for arguments, by setting: the
/// argument's name
/// @param given names of the arguments that those that join it have set
/// @param map of its world, as it calls it; empty when it has none
/// @param isThisMap whether a map of that name is the same for both
/// @param roles of its robots; empty when its world may bring more of them along
/// @param stands which role here stands for one of its own
/// @param saidAt where that is written
record Joined(
        Location at,
        String name,
        FileSource files,
        Value.Mapping agents,
        Map<String, Map<String, String>> placed,
        Set<String> given,
        String map,
        boolean isThisMap,
        Optional<Set<String>> roles,
        Map<String, String> stands,
        Map<String, Location> saidAt) {

    /// Notes what is wrong with the roles as they are said.
    void checkRoles(RobotNames robots, Problems problems) {
        stands.forEach((own, here) -> {
            Location place = saidAt.getOrDefault(own, at);
            if (roles.isPresent() && !roles.get().contains(own)) {
                problems.add(
                        place,
                        "Scenario '%s' has no robots of role '%s'.".formatted(name, own),
                        Suggestion.among(own, roles.get()));
            }
            if (robots.role(here).isEmpty() && !robots.open()) {
                problems.add(
                        place, "No robots have the role '%s'.".formatted(here), Suggestion.among(here, names(robots)));
            }
        });
    }

    /// The arguments of an agent with the roles of robots here in place of its own.
    Arguments here(AgentType type, Arguments own, RobotNames robots, Problems problems) {
        var values = new LinkedHashMap<>(own.asMap());
        for (Parameter<?> parameter : type.parameters()) {
            parameter
                    .ofRobots()
                    .map(own::get)
                    .filter(role -> !parameter.options().contains(role))
                    .ifPresent(role -> values.put(parameter.name(), here(role, robots, problems)));
        }
        return Arguments.of(type.parameters(), values);
    }

    private String here(String role, RobotNames robots, Problems problems) {
        String said = stands.get(role);
        if (said != null) {
            return said;
        }
        List<String> known = names(robots);
        if (known.size() == 1) {
            return known.getFirst();
        }
        boolean isMisspelt =
                roles.filter(own -> !own.containsAll(stands.keySet())).isPresent();
        if (!robots.mayLackSome() && !isMisspelt) {
            problems.add(
                    at,
                    "It is not given which robots here are '%s' of scenario '%s'.".formatted(role, name),
                    known.isEmpty()
                            ? "There are no robots here."
                            : "Write in a scenario file (with: {scenario: %s, robots: {%s: ROLE}}); roles here are: %s."
                                    .formatted(name, role, String.join(", ", known)));
        }
        return role;
    }

    /// Notes places of an agent that lie on another map than the one here.
    void checkPlaces(String agent, AgentType type, Arguments own, String mapHere, Problems problems) {
        if (map.isEmpty() || mapHere.isEmpty() || (isThisMap && map.equals(mapHere))) {
            return;
        }
        Map<String, String> arguments = placed.getOrDefault(agent, Map.of());
        for (Parameter<?> parameter : type.parameters()) {
            String argument = arguments.getOrDefault(parameter.name(), "");
            boolean areTheirs = parameter
                            .ofPlaces()
                            .filter(places -> !own.get(places).isEmpty())
                            .isPresent()
                    && !given.contains(argument);
            if (areTheirs) {
                problems.add(
                        at,
                        "'%s' of agent '%s' are places of map '%s', on which scenario '%s' is; the one here is '%s'."
                                .formatted(parameter.name(), agent, map, name, mapHere),
                        argument.isEmpty()
                                ? "Another scenario or configuration may have none."
                                : "Add 'arguments: {%s: \"x y; x y\"}' to 'with', places here, or none, (\"\")."
                                        .formatted(argument));
            }
        }
    }

    private static List<String> names(RobotNames robots) {
        return List.copyOf(new TreeSet<>(robots.roles().stream().map(Role::name).toList()));
    }

    /// Which settings of an agent stand for arguments of its scenario.
    ///
    /// @param args as they are written
    static Map<String, String> placed(Section args) {
        var placed = new LinkedHashMap<String, String>();
        args.mapping().entries().forEach((key, value) -> {
            if (value instanceof Value.Scalar scalar && scalar.value() instanceof String text && text.startsWith("$")) {
                placed.put(key, text.substring(1));
            }
        });
        return placed;
    }
}
