package rsal.navigation.control;

import java.util.List;
import rsal.navigation.avoid.Controller;
import rsal.navigation.nd.Nd;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes controllers by [Nd].
public final class NdControllerType implements ControllerType {
    private static final Parameter<Double> AVOID_DIST = Parameter.number(
            "avoidDist", 0.5, 0.05, 3, "m", "from what is nearer to its edge it turns away and slows down");
    private static final Parameter<Double> SAFETY_DIST =
            Parameter.number("safetyDist", 0, 0, 1, "m", "room around the robot that counts as part of it");

    @Override
    public String key() {
        return "nd";
    }

    @Override
    public String description() {
        return "Turns by what kind of gap is ahead (nearness diagram), as Player's nd does.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(AVOID_DIST, SAFETY_DIST);
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        return new Nd(
                driven.footprint(),
                driven.limits(),
                new Nd.Settings(arguments.get(AVOID_DIST), arguments.get(SAFETY_DIST)),
                driven.reaction());
    }
}
