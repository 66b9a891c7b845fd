package rsal.navigation.parameter;

import java.util.List;
import rsal.settings.Parameter;

/// What can be set of [rsal.navigation.amcl.Amcl].
public final class AmclParameters {
    public static final Parameter<String> MODEL = Parameter.choice(
            "model",
            "auto",
            List.of("auto", "field", "beam"),
            "how beams are judged: near walls (field) or as long as expected (beam); auto: beam for sonars");
    public static final Parameter<Integer> BEAMS =
            Parameter.integer("beams", 60, 5, 1000, "", "beams of a laser scan to look at");
    public static final Parameter<Double> MAX_RANGE =
            Parameter.number("maxRange", 30, 0.5, 200, "m", "ranges beyond this are not looked at");
    public static final Parameter<Double> HIT_DEVIATION =
            Parameter.number("hitDeviation", 0.1, 0.01, 1, "m", "how far laser hits are from the map's walls");
    public static final Parameter<Double> SONAR_DEVIATION =
            Parameter.number("sonarDeviation", 0.25, 0.01, 1, "m", "the same for sonars");
    public static final Parameter<Double> RANDOM_SHARE = Parameter.number(
            "randomShare", 0.05, 0.001, 0.5, "", "share of readings that have nothing to do with the map");
    public static final Parameter<Double> INDEPENDENT_BEAMS =
            Parameter.number("independentBeams", 15, 1, 1000, "", "how many beams a scan counts for");
    public static final Parameter<Double> INDEPENDENT_SONARS =
            Parameter.number("independentSonars", 3, 1, 1000, "", "how many of a round of sonars count");
    public static final Parameter<Integer> MIN_PARTICLES =
            Parameter.integer("minParticles", 150, 20, 100_000, "", "particles when it knows well where it is");
    public static final Parameter<Integer> MAX_PARTICLES =
            Parameter.integer("maxParticles", 5000, 100, 100_000, "", "particles when it knows least");
    public static final Parameter<Double> UPDATE_DISTANCE =
            Parameter.number("updateDistance", 0.1, 0.01, 5, "m", "distance after which it uses a scan");
    public static final Parameter<Double> UPDATE_ANGLE =
            Parameter.number("updateAngle", 6, 0.5, 180, "deg", "turn after which it looks at a scan");
    public static final Parameter<Double> INITIAL_DEVIATION =
            Parameter.number("initialDeviation", 0.2, 0, 100, "m", "how uncertain the start position is");
    public static final Parameter<Double> INITIAL_ANGLE_DEVIATION =
            Parameter.number("initialAngleDeviation", 10, 0, 360, "deg", "how uncertain the start heading is");
    public static final Parameter<Double> ODOMETRY_NOISE_SCALE =
            Parameter.number("odometryNoiseScale", 2, 0.5, 20, "", "factor on the odometry noise of the robot's model");

    /// In the order in which people read them.
    public static final List<Parameter<?>> ALL = List.of(
            MODEL,
            BEAMS,
            MAX_RANGE,
            HIT_DEVIATION,
            SONAR_DEVIATION,
            RANDOM_SHARE,
            INDEPENDENT_BEAMS,
            INDEPENDENT_SONARS,
            MIN_PARTICLES,
            MAX_PARTICLES,
            UPDATE_DISTANCE,
            UPDATE_ANGLE,
            INITIAL_DEVIATION,
            INITIAL_ANGLE_DEVIATION,
            ODOMETRY_NOISE_SCALE);

    private AmclParameters() {}
}
