package rsal.navigation.parameter;

import java.util.List;
import rsal.settings.Parameter;

/// What can be set of [rsal.navigation.amcl.Amcl].
public final class AmclParameters {
    public static final Parameter<String> MODEL = Parameter.choice(
            "model",
            "auto",
            List.of("auto", "field", "beam"),
            "sensor model: distance of a beam's end from walls (field), or expected range (beam); auto: beam for"
                    + " sonars");
    public static final Parameter<Integer> BEAMS =
            Parameter.integer("beams", 60, 5, 1000, "", "number of beams of a laser scan to use");
    public static final Parameter<Double> MAX_RANGE =
            Parameter.number("maxRange", 30, 0.5, 200, "m", "longer ranges are ignored");
    public static final Parameter<Double> HIT_DEVIATION = Parameter.number(
            "hitDeviation", 0.1, 0.01, 1, "m", "standard deviation of laser hits from the walls of the map");
    public static final Parameter<Double> SONAR_DEVIATION =
            Parameter.number("sonarDeviation", 0.25, 0.01, 1, "m", "the same for sonars");
    public static final Parameter<Double> RANDOM_SHARE =
            Parameter.number("randomShare", 0.05, 0.001, 0.5, "", "share of readings that are independent of the map");
    public static final Parameter<Double> INDEPENDENT_BEAMS =
            Parameter.number("independentBeams", 15, 1, 1000, "", "weight of a scan, as a number of independent beams");
    public static final Parameter<Double> INDEPENDENT_SONARS = Parameter.number(
            "independentSonars", 3, 1, 1000, "", "weight of a round of sonars, as a number of independent sonars");
    public static final Parameter<Integer> MIN_PARTICLES = Parameter.integer(
            "minParticles", 150, 20, 100_000, "", "number of particles when the pose is most certain");
    public static final Parameter<Integer> MAX_PARTICLES = Parameter.integer(
            "maxParticles", 5000, 100, 100_000, "", "number of particles when the pose is most uncertain");
    public static final Parameter<Double> UPDATE_DISTANCE =
            Parameter.number("updateDistance", 0.1, 0.01, 5, "m", "distance after which it processes a scan");
    public static final Parameter<Double> UPDATE_ANGLE =
            Parameter.number("updateAngle", 6, 0.5, 180, "deg", "rotation after which it processes a scan");
    public static final Parameter<Double> INITIAL_DEVIATION =
            Parameter.number("initialDeviation", 0.2, 0, 100, "m", "standard deviation of the start position");
    public static final Parameter<Double> INITIAL_ANGLE_DEVIATION =
            Parameter.number("initialAngleDeviation", 10, 0, 360, "deg", "standard deviation of the start heading");
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
