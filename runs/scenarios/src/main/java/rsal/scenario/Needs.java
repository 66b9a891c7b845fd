package rsal.scenario;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Types of devices that agents need, and which of their arguments is why.
///
/// @param arguments empty when they can't be read
record Needs(AgentType type, Optional<Arguments> arguments) {
    List<Class<? extends Device>> all() {
        return arguments.map(type::needs).orElseGet(type::needs);
    }

    /// In messages: `Agent 'follow' with 'sees: fiducials'`, with the arguments but for which it would need less of
    /// what is missing.
    String whose(List<Class<? extends Device>> missing) {
        String why = arguments.stream()
                .filter(_ -> !type.needs().containsAll(missing))
                .flatMap(given -> type.parameters().stream()
                        .filter(parameter -> matters(parameter, given, missing))
                        .map(parameter -> " with '%s: %s'"
                                .formatted(parameter.name(), given.asMap().get(parameter.name()))))
                .collect(Collectors.joining(" and"));
        return "Agent '%s'%s".formatted(type.key(), why);
    }

    private boolean matters(Parameter<?> parameter, Arguments given, List<Class<? extends Device>> missing) {
        if (parameter.fallback().isEmpty()) {
            return false;
        }
        var values = new LinkedHashMap<>(given.asMap());
        values.put(parameter.name(), parameter.fallback().get());
        return !type.needs(Arguments.of(type.parameters(), values)).containsAll(missing);
    }
}
