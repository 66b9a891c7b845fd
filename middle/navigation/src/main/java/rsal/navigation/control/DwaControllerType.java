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
        return "Chooses among speeds that it can reach at once by where they lead (dynamic window approach).";
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        return new Dwa(
                driven.footprint(), driven.limits(), Dwa.Settings.of(HORIZON, driven.lookahead()), driven.reaction());
    }
}
