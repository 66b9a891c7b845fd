package rsal.agents.pursuit;

import java.util.List;
import java.util.Optional;
import java.util.ServiceLoader;
import rsal.agent.AgentContext;
import rsal.agents.exploration.Viewpoints;
import rsal.agents.parts.AgentTypeBase;
import rsal.agents.parts.PoseReporter;
import rsal.agents.parts.RequiredRobot;
import rsal.agents.pursuit.strategy.PursuitStrategyType;
import rsal.device.Device;
import rsal.device.Navigator;
import rsal.settings.Arguments;
import rsal.settings.Parameter;
import rsal.settings.PluginChoice;
import rsal.settings.PluginKind;

/// A hunter: goes for the newest pose of a prey until that has been caught, then for the next. Driving where it is
/// told comes first.
public final class Follow extends AgentTypeBase {
    static final Parameter<String> PREY =
            Parameter.robots("prey", "prey", List.of(), "Role of the robots to hunt, or id of one robot.");
    static final Parameter<Double> CATCH_DISTANCE =
            Parameter.number("catchDistance", 2.0, 0.1, 100, "m", "It stops when its prey is nearer than this.");
    /// As the thesis's real runs had it; simulated ones had 5 s.
    static final Parameter<Double> UPDATE_INTERVAL = Parameter.number(
            "updateInterval", 2.0, 0.1, 600, "s", "Time between two updates of its goal to the prey's newest pose.");
    static final Parameter<String> ASSIGNMENT = Parameter.choice(
            "assignment",
            "fixed",
            List.of("fixed", "nearest", "bids"),
            "How hunters divide several prey: in turn, at the start (fixed); again at each update, with the least"
                    + " total distance (nearest); or by bids to an agent of type 'hunt'.");

    static final Parameter<PluginChoice> STRATEGY = Parameter.plugin(
            "strategy",
            "direct",
            PluginKind.of("pursuitStrategy", PursuitStrategyType.class, ServiceLoader.load(PursuitStrategyType.class)),
            "decides where each hunter drives; with 'assignment: bids' only 'direct'");

    public Follow() {
        super(
                "follow",
                "Hunts: drives to the newest pose of a prey until the prey is caught.",
                List.of(
                        PREY,
                        CATCH_DISTANCE,
                        UPDATE_INTERVAL,
                        ASSIGNMENT,
                        STRATEGY,
                        MarkerSight.SEES,
                        Viewpoints.COUNT,
                        PoseReporter.PERIOD),
                List.of(Navigator.class));
    }

    @Override
    protected List<Class<? extends Device>> needsBesides(Arguments arguments) {
        return PreySearch.needs(arguments);
    }

    @Override
    public Optional<String> needsAgent(Arguments arguments) {
        return arguments.get(ASSIGNMENT).equals("bids") ? Optional.of(HuntMaster.KEY) : Optional.empty();
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        if (arguments.get(ASSIGNMENT).equals("bids")) {
            new Hunter(self, RequiredRobot.of(self), arguments).begin();
        } else {
            new Hunt(self, RequiredRobot.of(self), arguments).begin();
        }
    }
}
