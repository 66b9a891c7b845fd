package rsal.jadex.hunt;

import jadex.bridge.IInternalAccess;
import jadex.bridge.component.impl.IInternalExecutionFeature;
import java.util.List;
import rsal.agent.Agent;
import rsal.agent.AgentContext;
import rsal.agent.AgentType;
import rsal.device.Device;
import rsal.device.Localizer;
import rsal.device.Navigator;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// A hunter whose goals are Jadex's. Lives on the host `jadex` only.
public final class JadexHunter implements AgentType {
    static final Parameter<String> PREY =
            Parameter.robots("prey", "prey", List.of(), "Role of the robots to hunt, or id of one robot.");
    static final Parameter<Double> CATCH_DISTANCE =
            Parameter.number("catchDistance", 2.0, 0.1, 100, "m", "It stops when its prey is nearer than this.");
    static final Parameter<Double> UPDATE_INTERVAL = Parameter.number(
            "updateInterval", 2.0, 0.1, 600, "s", "Time between two updates of its goal to the prey's newest pose.");
    static final Parameter<Double> PERIOD =
            Parameter.number("period", 0.5, 0.05, 60, "s", "Time between two reports of its pose.");

    @Override
    public String key() {
        return "jadex-hunter";
    }

    @Override
    public String description() {
        return "Hunts a prey by goals and plans of Jadex's BDI kernel. Needs (mas: {use: jadex}).";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(PREY, CATCH_DISTANCE, UPDATE_INTERVAL, PERIOD);
    }

    @Override
    public List<Class<? extends Device>> needs() {
        return List.of(Navigator.class, Localizer.class);
    }

    @Override
    public Agent create(Arguments arguments) {
        return self -> {
            IInternalAccess body = body(self);
            new JadexHunt(self, arguments).begin(body);
        };
    }

    /// The Jadex agent on whose thread it is.
    ///
    /// @throws IllegalStateException on other hosts than Jadex
    private static IInternalAccess body(AgentContext self) {
        IInternalAccess body = IInternalExecutionFeature.LOCAL.get();
        if (body == null) {
            throw new IllegalStateException(
                    "Agent '%s' uses Jadex and needs its platform. Maybe run it by '--mas jadex --clock wall'."
                            .formatted(self.name()));
        }
        return body;
    }
}
