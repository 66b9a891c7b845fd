package rsal.agents.parts;

import java.util.List;
import java.util.stream.Stream;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.agent.presence.Presence;
import rsal.device.Device;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A kind of agent that is put together from parts when it starts, and lets others know that it is there until it ends.
public abstract class AgentTypeBase implements AgentType {
    private final String key;
    private final String description;
    private final List<Parameter<?>> parameters;
    private final List<Class<? extends Device>> needs;

    /// @param needs types of devices without which it can't work; none for agents without a robot
    public AgentTypeBase(
            String key, String description, List<Parameter<?>> parameters, List<Class<? extends Device>> needs) {
        this.key = key;
        this.description = description;
        this.parameters = parameters;
        this.needs = needs;
    }

    /// Puts the parts of one agent together and begins. Called on the agent's lane; an exception ends the agent.
    protected abstract void begin(AgentContext self, Arguments arguments);

    @Override
    public final String key() {
        return key;
    }

    @Override
    public final String description() {
        return description;
    }

    @Override
    public final List<Parameter<?>> parameters() {
        return parameters;
    }

    @Override
    public final List<Class<? extends Device>> needs() {
        return needs;
    }

    @Override
    public final List<Class<? extends Device>> needs(Arguments arguments) {
        return Stream.concat(needs.stream(), needsBesides(arguments).stream())
                .distinct()
                .toList();
    }

    /// What one with such arguments needs besides.
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return List.of();
    }

    @Override
    public final Agent create(Arguments arguments) {
        return new Agent() {
            @Override
            public void start(AgentContext self) {
                Markers.publish(self);
                begin(self, arguments);
                Presence.begin(self);
            }

            @Override
            public void stop(AgentContext self) {
                Presence.end(self);
            }
        };
    }
}
