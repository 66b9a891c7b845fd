package rsal.java;

import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import rsal.agent.Agent;
import rsal.agent.AgentOutline;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.InvalidSettings;
import rsal.settings.Parameter;
import rsal.settings.Problem;

/// A kind of agent that somebody wrote in a Java file of their own: as it says of itself, but called by the
/// file.
///
/// @param key path of the file
record JavaType(String key, String description, List<Parameter<?>> parameters, AgentType own) implements AgentType {
    private static final JavaClass.Use AGENT = new JavaClass.Use(
            "agent",
            List.of(AgentType.class, Agent.class),
            "Let it implement rsal.agent.Agent, or rsal.agent.AgentType when it has parameters.");

    JavaType {
        parameters = List.copyOf(parameters);
    }

    /// @throws InvalidSettings when the file has no class that can be used
    static AgentType of(Sources sources, FolderClasses classes) {
        JavaClass own = JavaClass.of(sources, classes, AGENT);
        if (own.is(Agent.class)) {
            return new JavaType(
                    sources.path(),
                    sources.description(),
                    List.of(),
                    new Plain(sources.path(), sources.description(), () -> own.create(Agent.class)));
        }
        AgentType type = own.create(AgentType.class);
        return own.blaming(() -> new JavaType(sources.path(), type.description(), type.parameters(), type));
    }

    /// A kind of agent without anything that can be set.
    private record Plain(String key, String description, Supplier<Agent> maker) implements AgentType {
        @Override
        public Agent create(Arguments arguments) {
            return maker.get();
        }
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return own.needs();
    }

    @Override
    public List<Class<? extends Device>> needs(Arguments arguments) {
        return own.needs(arguments);
    }

    @Override
    public boolean drives(Arguments arguments) {
        return own.drives(arguments);
    }

    @Override
    public Optional<String> needsAgent(Arguments arguments) {
        return own.needsAgent(arguments);
    }

    @Override
    public boolean yields() {
        return own.yields();
    }

    @Override
    public Optional<AgentOutline> outline() {
        return own.outline();
    }

    @Override
    public List<Problem> warnings() {
        return own.warnings();
    }

    @Override
    public Agent create(Arguments arguments) {
        return own.create(arguments);
    }
}
