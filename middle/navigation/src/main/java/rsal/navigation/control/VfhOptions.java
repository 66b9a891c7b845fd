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

    private VfhOptions() {}

    static List<Parameter> parameters() {
        return List.of(
                Parameter.number("safetyDist0ms", 0.1, 0, 1, "m", "room that it keeps from obstacles while standing"),
                Parameter.number("safetyDist1ms", 0.4, 0, 2, "m", "room that it keeps from obstacles at 1 m/s"),
                Parameter.number(
                        "windowDiameter",
                        0,
                        0,
                        200,
                        "cells",
                        "it looks so far to all sides together; 0: twice 0.6 m" + " and what it drives in 2 s"),
                Parameter.number("cellSize", 0.1, 0.01, 1, "m", "what windowDiameter is counted in"),
                Parameter.number("sectorAngle", 5, 1, 30, "deg", "between directions that it tells apart"),
                Parameter.number(
                        "maxSpeedNarrowOpening",
                        NO_LIMIT,
                        0.05,
                        NO_LIMIT,
                        "m/s",
                        "it is never faster in openings of" + " less than 80°"),
                Parameter.number(
                        "maxSpeedWideOpening", NO_LIMIT, 0.05, NO_LIMIT, "m/s", "it is never faster in wider ones"),
                Parameter.number(
                        "maxTurnRate0ms",
                        NO_TURN_LIMIT,
                        5,
                        NO_TURN_LIMIT,
                        "deg/s",
                        "it never turns faster while" + " standing"),
                Parameter.number(
                        "maxTurnRate1ms", NO_TURN_LIMIT, 5, NO_TURN_LIMIT, "deg/s", "it never turns faster at 1 m/s"),
                Parameter.number(
                        "minTurnRadiusSafetyFactor", 1, 0.1, 10, "", "it takes curves for so many times wider"),
                Parameter.number(
                        "weightDesiredDir",
                        5,
                        0,
                        100,
                        "",
                        "what it is worth to go to the target; more" + " than the other two weights together"),
                Parameter.number("weightCurrentDir", 2, 0, 100, "", "what it is worth to go straight on"),
                Parameter.number("weightPreviousDir", 2, 0, 100, "", "what it is worth to keep its choice"));
    }

    /// How far it looks [m].
    static double window(Arguments arguments, double otherwise) {
        double diameter = arguments.number("windowDiameter") * arguments.number("cellSize");
        return diameter > 0 ? diameter / 2 : otherwise;
    }

    /// @param lookahead how far it looks where no window is set [m]
    static Vfh.Settings settings(Arguments arguments, double lookahead) {
        double standing = arguments.number("safetyDist0ms");
        double more = Math.max(AT_LEAST, arguments.number("safetyDist1ms") - standing);
        return new Vfh.Settings(
                window(arguments, lookahead),
                standing,
                more,
                arguments.radians("sectorAngle"),
                new Vfh.Openings(arguments.number("maxSpeedNarrowOpening"), arguments.number("maxSpeedWideOpening")),
                new Vfh.Turning(
                        arguments.radians("maxTurnRate0ms"),
                        arguments.radians("maxTurnRate1ms"),
                        arguments.number("minTurnRadiusSafetyFactor")),
                weights(arguments));
    }

    /// Why it can't weigh directions so, in a sentence; empty when it can.
    static Optional<String> refusal(Arguments arguments) {
        try {
            weights(arguments);
            return Optional.empty();
        } catch (IllegalArgumentException e) {
            return Optional.of("%s Raise (weightDesiredDir), or lower (weightCurrentDir) or (weightPreviousDir)."
                    .formatted(e.getMessage()));
        }
    }

    private static Vfh.Weights weights(Arguments arguments) {
        return new Vfh.Weights(
                arguments.number("weightDesiredDir"),
                arguments.number("weightCurrentDir"),
                arguments.number("weightPreviousDir"));
    }
}
