package rsal.navigation.control;

import rsal.navigation.avoid.Controller;
import rsal.navigation.dwa.Dwa;
import rsal.settings.Arguments;

/// Makes controllers by [Dwa].
public final class DwaControllerType implements ControllerType {
    private static final double HORIZON = 0.25; // s

    @Override
    public String key() {
        return "dwa";
    }

    @Override
    public String description() {
        return "Chooses the best of the velocities that the robot can reach at once (dynamic window approach).";
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        return new Dwa(
                driven.footprint(), driven.limits(), Dwa.Settings.of(HORIZON, driven.lookahead()), driven.reaction());
    }
}
