package rsal.agents.formation;

import java.util.List;
import rsal.agent.AgentContext;
import rsal.agent.message.NewGoal;
import rsal.agents.parts.AgentTypeBase;
import rsal.data.Point2d;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Leads a team through the map in a formation, each robot at a place of its own in it. Where there is no room it goes
/// in a column. Needs no robot.
public final class Formation extends AgentTypeBase {
    static final Parameter<String> ROBOTS =
            Parameter.robots("robots", NewGoal.ALL, List.of(NewGoal.ALL), "Role of the robots to lead, or all.");
    static final Parameter<String> SHAPE =
            Parameter.choice("shape", FormationShape.WEDGE.word(), FormationShape.words(), "Shape of the formation.");
    static final Parameter<Double> SPACING =
            Parameter.number("spacing", 1.5, 0.6, 20, "m", "Distance of neighbors in the formation.");
    static final Parameter<List<Point2d>> ROUTE = Parameter.places(
            "route",
            "Route of the formation: first the place at which the robots meet, then one place after the other.");
    static final Parameter<Double> SPEED = Parameter.number(
            "speed", 0.25, 0.02, 3, "m/s", "Speed of the formation while all robots are at their places.");
    static final Parameter<Double> TIMEOUT =
            Parameter.number("timeout", 3, 1, 600, "s", "A robot that has been silent for this time loses its place.");

    public Formation() {
        super(
                "formation",
                "Leads a team through the map in a formation, or in a column if there is no room for the formation.",
                List.of(ROBOTS, SHAPE, SPACING, ROUTE, SPEED, TIMEOUT),
                List.of());
    }

    @Override
    protected void begin(AgentContext self, Arguments arguments) {
        if (arguments.get(ROUTE).size() < 2) {
            throw new IllegalArgumentException(
                    "Agent '%s' needs a route of at least two places. Maybe set its argument 'route' to \"0 0; 10 0\"."
                            .formatted(self.name()));
        }
        new VirtualStructure(self, arguments).begin();
    }
}
