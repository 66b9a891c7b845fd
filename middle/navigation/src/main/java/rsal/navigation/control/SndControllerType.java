package rsal.navigation.control;

import java.util.List;
import rsal.navigation.avoid.Controller;
import rsal.navigation.avoid.FootprintOutline;
import rsal.navigation.snd.Snd;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes controllers by [Snd].
public final class SndControllerType implements ControllerType {
    private static final Parameter<Double> OBSTACLE_AVOID_DIST = Parameter.number(
            "obstacleAvoidDist",
            0.6,
            0.05,
            5,
            "m",
            "the robot turns away from obstacles nearer to its edge than" + " this");
    private static final Parameter<Double> MIN_GAP_WIDTH =
            Parameter.number("minGapWidth", 0.5, 0.05, 3, "m", "minimum jump of neighboring ranges at a gap");
    private static final Parameter<Double> ROBOT_RADIUS = Parameter.number(
            "robotRadius",
            0,
            0,
            3,
            "m",
            "radius of the circle that represents the robot; 0: the radius of the" + " robot");

    @Override
    public String key() {
        return "snd";
    }

    @Override
    public String description() {
        return "Turns away from near obstacles, the more the nearer they are (smooth nearness diagram), as Player's"
                + " snd does.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return List.of(OBSTACLE_AVOID_DIST, MIN_GAP_WIDTH, ROBOT_RADIUS);
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        double radius = arguments.get(ROBOT_RADIUS);
        return new Snd(
                driven.footprint(),
                driven.limits(),
                new Snd.Settings(
                        radius > 0 ? radius : FootprintOutline.radius(driven.footprint()),
                        arguments.get(MIN_GAP_WIDTH),
                        arguments.get(OBSTACLE_AVOID_DIST)),
                driven.reaction());
    }
}
