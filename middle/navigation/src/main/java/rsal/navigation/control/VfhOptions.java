package rsal.navigation.control;

import java.util.List;
import java.util.Optional;
import rsal.navigation.vfh.Vfh;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// What can be set of [Vfh], named as in Player.
final class VfhOptions {
    private static final double NO_LIMIT = 3; // m/s
    private static final double NO_TURN_LIMIT = 360; // deg/s
    private static final double AT_LEAST = 0.01; // m per m/s; more room at speed

    private static final Parameter<Double> SAFETY_DIST0MS =
            Parameter.number("safetyDist0ms", 0.1, 0, 1, "m", "clearance from obstacles while standing");
    private static final Parameter<Double> SAFETY_DIST1MS =
            Parameter.number("safetyDist1ms", 0.4, 0, 2, "m", "clearance from obstacles at 1 m/s");
    private static final Parameter<Double> WINDOW_DIAMETER = Parameter.number(
            "windowDiameter",
            0,
            0,
            200,
            "cells",
            "diameter of the area around the robot that it uses; 0: twice 0.6 m plus the distance of 2 s");
    private static final Parameter<Double> CELL_SIZE =
            Parameter.number("cellSize", 0.1, 0.01, 1, "m", "unit of windowDiameter");
    private static final Parameter<Double> SECTOR_ANGLE =
            Parameter.number("sectorAngle", 5, 1, 30, "deg", "angle between neighboring directions");
    private static final Parameter<Double> MAX_SPEED_NARROW_OPENING = Parameter.number(
            "maxSpeedNarrowOpening", NO_LIMIT, 0.05, NO_LIMIT, "m/s", "maximum speed in openings of less than 80°");
    private static final Parameter<Double> MAX_SPEED_WIDE_OPENING =
            Parameter.number("maxSpeedWideOpening", NO_LIMIT, 0.05, NO_LIMIT, "m/s", "maximum speed in wider openings");
    private static final Parameter<Double> MAX_TURN_RATE0MS = Parameter.number(
            "maxTurnRate0ms", NO_TURN_LIMIT, 5, NO_TURN_LIMIT, "deg/s", "maximum turn rate while standing");
    private static final Parameter<Double> MAX_TURN_RATE1MS =
            Parameter.number("maxTurnRate1ms", NO_TURN_LIMIT, 5, NO_TURN_LIMIT, "deg/s", "maximum turn rate at 1 m/s");
    private static final Parameter<Double> MIN_TURN_RADIUS_SAFETY_FACTOR = Parameter.number(
            "minTurnRadiusSafetyFactor",
            1,
            0.1,
            10,
            "",
            "safety factor of the turn radius: it assumes wider" + " curves");
    private static final Parameter<Double> WEIGHT_DESIRED_DIR = Parameter.number(
            "weightDesiredDir",
            5,
            0,
            100,
            "",
            "weight of the direction of the target; more than the other two weights together");
    private static final Parameter<Double> WEIGHT_CURRENT_DIR =
            Parameter.number("weightCurrentDir", 2, 0, 100, "", "weight of the present direction");
    private static final Parameter<Double> WEIGHT_PREVIOUS_DIR =
            Parameter.number("weightPreviousDir", 2, 0, 100, "", "weight of the previously chosen direction");

    private VfhOptions() {}

    static List<Parameter<?>> parameters() {
        return List.of(
                SAFETY_DIST0MS,
                SAFETY_DIST1MS,
                WINDOW_DIAMETER,
                CELL_SIZE,
                SECTOR_ANGLE,
                MAX_SPEED_NARROW_OPENING,
                MAX_SPEED_WIDE_OPENING,
                MAX_TURN_RATE0MS,
                MAX_TURN_RATE1MS,
                MIN_TURN_RADIUS_SAFETY_FACTOR,
                WEIGHT_DESIRED_DIR,
                WEIGHT_CURRENT_DIR,
                WEIGHT_PREVIOUS_DIR);
    }

    /// How far it looks [m].
    static double window(Arguments arguments, double otherwise) {
        double diameter = arguments.get(WINDOW_DIAMETER) * arguments.get(CELL_SIZE);
        return diameter > 0 ? diameter / 2 : otherwise;
    }

    /// @param lookahead how far it looks where no window is set [m]
    static Vfh.Settings settings(Arguments arguments, double lookahead) {
        double standing = arguments.get(SAFETY_DIST0MS);
        double more = Math.max(AT_LEAST, arguments.get(SAFETY_DIST1MS) - standing);
        return new Vfh.Settings(
                window(arguments, lookahead),
                standing,
                more,
                arguments.radians(SECTOR_ANGLE),
                new Vfh.Openings(arguments.get(MAX_SPEED_NARROW_OPENING), arguments.get(MAX_SPEED_WIDE_OPENING)),
                new Vfh.Turning(
                        arguments.radians(MAX_TURN_RATE0MS),
                        arguments.radians(MAX_TURN_RATE1MS),
                        arguments.get(MIN_TURN_RADIUS_SAFETY_FACTOR)),
                weights(arguments));
    }

    /// Why it can't weigh directions so, in a sentence; empty when it can.
    static Optional<String> refusal(Arguments arguments) {
        try {
            weights(arguments);
            return Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.of("%s Raise 'weightDesiredDir', or lower 'weightCurrentDir' or 'weightPreviousDir'."
                    .formatted(e.getMessage()));
        }
    }

    private static Vfh.Weights weights(Arguments arguments) {
        return new Vfh.Weights(
                arguments.get(WEIGHT_DESIRED_DIR),
                arguments.get(WEIGHT_CURRENT_DIR),
                arguments.get(WEIGHT_PREVIOUS_DIR));
    }
}
