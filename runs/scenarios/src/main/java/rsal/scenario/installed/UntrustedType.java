package rsal.scenario.installed;

import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentType;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.Section;
import rsal.settings.Value;

/// In place of an agent whose file is a program from who knows where, as from a recording: the run can be
/// looked at, but the program is neither read nor run.
///
/// @param key path of the file
/// @param parameters those that the scenario sets, as it sets them
public record UntrustedType(String key, List<Parameter<?>> parameters) implements AgentType {
    public UntrustedType {
        parameters = List.copyOf(parameters);
    }

    /// @param args of the agent in the scenario
    public static UntrustedType of(String file, Section args) {
        return new UntrustedType(
                file,
                args.mapping().entries().entrySet().stream()
                        .<Parameter<?>>map(set -> parameter(set.getKey(), set.getValue()))
                        .toList());
    }

    private static Parameter<?> parameter(String name, Value value) {
        Object set = value instanceof Value.Scalar scalar ? scalar.value() : "";
        return switch (set) {
            case Boolean flag -> Parameter.flag(name, flag, "");
            case Number number ->
                Parameter.number(
                        name, number.doubleValue(), Double.NEGATIVE_INFINITY, Double.POSITIVE_INFINITY, "", "");
            default -> Parameter.text(name, set.toString(), "");
        };
    }

    @Override
    public String description() {
        return "A program that came with a recording, which is not run.";
    }

    @Override
    public Agent create(Arguments arguments) {
        return _ -> {
            throw new IllegalStateException(
                    "Agent '%s' is a program that came with a recording, and such are not run.".formatted(key));
        };
    }
}
