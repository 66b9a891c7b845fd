package rsal.engine.agent;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Stream;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.robot.Robot;
import rsal.scenario.RunPlan.PlannedAgent;
import rsal.scenario.installed.Providers;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Suggestion;

/// An agent that a person wants by hand: of a type that is installed, with arguments as they were typed.
public final class TypedAgent {
    private TypedAgent() {}

    /// What there is to be had.
    public static Map<String, AgentType> types() {
        return Providers.byKey(AgentType.class, AgentType::key);
    }

    /// @param robot that it is to act for; empty for none
    /// @param typed by argument; those that are left out are as the type has them
    /// @param team robots that are there
    /// @param seed of the run
    /// @return named after its type
    /// @throws IllegalArgumentException with sentences about all that is wrong with it
    public static PlannedAgent read(
            String key, Optional<Robot> robot, Map<String, String> typed, List<Robot> team, long seed) {
        AgentType type = types().get(key);
        if (type == null) {
            throw new IllegalArgumentException("There is no type '%s' of agents. %s"
                    .formatted(key, Suggestion.among(key, List.copyOf(types().keySet()))));
        }
        Arguments arguments = arguments(type.parameters(), typed, team);
        checkNeeds(type, arguments, robot);
        return new PlannedAgent(key, key, type, arguments, robot.map(Robot::id), seed);
    }

    private static Arguments arguments(List<Parameter<?>> parameters, Map<String, String> typed, List<Robot> team) {
        Arguments arguments = Arguments.parse(parameters, typed);
        List<String> names = team.stream()
                .flatMap(robot -> Stream.of(robot.role(), robot.id()))
                .distinct()
                .toList();
        parameters.stream().flatMap(each -> each.ofRobots().stream()).forEach(parameter -> {
            String name = arguments.get(parameter);
            if (!parameter.options().contains(name) && !names.contains(name)) {
                throw new IllegalArgumentException("'%s' must be %s, not '%s'. %s"
                        .formatted(parameter.name(), parameter.expected(), name, Suggestion.among(name, names)));
            }
        });
        return arguments;
    }

    private static void checkNeeds(AgentType type, Arguments arguments, Optional<Robot> robot) {
        List<Class<? extends Device>> needs = type.needs(arguments);
        if (robot.isEmpty() && !needs.isEmpty()) {
            throw new IllegalArgumentException("Agents '%s' need a robot that they act for.".formatted(type.key()));
        }
        List<String> missing = needs.stream()
                .filter(need -> robot.flatMap(body -> body.find(need)).isEmpty())
                .map(Class::getSimpleName)
                .toList();
        if (!missing.isEmpty()) {
            throw new IllegalArgumentException("Agents '%s' need a device that robot '%s' has not: %s."
                    .formatted(type.key(), robot.map(Robot::id).orElse(""), String.join(", ", missing)));
        }
    }
}
