package rsal.navigation.control;

import java.util.List;
import rsal.navigation.avoid.Controller;
import rsal.navigation.nd.Nd;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes controllers by [Nd].
public final class NdControllerType implements ControllerType {
    private static final Parameter<Double> AVOID_DIST = Parameter.number(
            "avoidDist",
            0.5,
            0.05,
            3,
            "m",
            "the robot turns away from obstacles nearer to its edge than this, and slows down");
    private static final Parameter<Double> SAFETY_DIST =
            Parameter.number("safetyDist", 0, 0, 1, "m", "margin around the robot that counts as part of it");

    @Override
    public String key() {
        return "nd";
    }

    @Override
    public String description() {
        return "Selects one of six situations by the gaps ahead (nearness diagram), as Player's nd does.";
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
