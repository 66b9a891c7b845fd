package rsal.system;

import rsal.settings.Parameter;

/// What can be set of systems of real robots, by the same words for all.
public final class RealRobots {
    public static final Parameter<Double> WATCHDOG =
            Parameter.number("watchdog", 0.5, 0.1, 10, "s", "A base stops after this time without a command.");
    public static final Parameter<Boolean> ARMED = Parameter.flag(
            "armed", false, "Whether motors are on from the beginning. If not, robots stand until somebody arms them.");

    private RealRobots() {}
}
