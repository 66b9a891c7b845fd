package rsal.scenario.installed;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;
import rsal.settings.Location;
import rsal.settings.Parameter;
import rsal.settings.Problem;
import rsal.settings.Section;

/// In place of an agent whose language can't be read on this machine, as Python where there is none. The scenario can
/// be
/// looked at; in a run, the agent fails and says why.
///
/// @param key path of the file
/// @param parameters those that the scenario sets, as it sets them
/// @param why its language can't be read, and what to do
public record UnavailableType(String key, List<Parameter<?>> parameters, Problem why) implements AgentType {
    public UnavailableType {
        parameters = List.copyOf(parameters);
    }

    /// @param args of the agent in the scenario
    /// @param at where the file is named
    public static UnavailableType of(String file, Section args, Location at, String why) {
        return new UnavailableType(
                file,
                UntrustedType.of(file, args).parameters(),
                new Problem(at, "'%s' was not checked: %s".formatted(file, why), ""));
    }

    @Override
    public String description() {
        return "";
    }

    @Override
    public List<Problem> warnings() {
        return List.of(why);
    }

    @Override
    public Agent create(Arguments arguments) {
        return _ -> {
            throw new IllegalStateException(why.message());
        };
    }
}
