package rsal.bench.mas;

import java.util.ArrayList;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import rsal.agent.AgentSpec;
import rsal.agent.AgentType;
import rsal.agent.bdi.Mind;
import rsal.bare.BareLanguage;
import rsal.bare.BareLanguage.Program;

/// Programs of a language on our host.
///
/// @param types the programs, as the host has read them
record LanguageAgents(BenchAgents platform, Map<Program, AgentType> types) implements BareLanguage.Platform {
    @Override
    public void start(Map<String, Program> agents) {
        var specs = new ArrayList<AgentSpec>();
        agents.forEach((name, program) -> {
            AgentType type = Objects.requireNonNull(types.get(program));
            specs.add(BenchAgents.spec(name, specs.size(), type, arguments(type)));
        });
        platform.start(specs);
    }

    private Map<String, Double> arguments(AgentType type) {
        boolean waits = type.parameters().stream()
                .anyMatch(parameter -> parameter.name().equals(BareLanguage.MOMENT));
        return waits ? Map.of(BareLanguage.MOMENT, (double) platform.moment().toMillis()) : Map.of();
    }

    @Override
    public long count(String agent) {
        return platform.look(agent, Mind.View.class)
                .flatMap(mind -> Optional.ofNullable(mind.beliefs().get(BareLanguage.COUNT)))
                .map(LanguageAgents::number)
                .orElse(0L); // it has not begun
    }

    /// Of a belief as it is written: `count(3)[source(self)]`.
    private static long number(String belief) {
        return (long) Double.parseDouble(belief.substring(belief.indexOf('(') + 1, belief.indexOf(')')));
    }

    @Override
    public void close() {
        platform.close();
    }
}
