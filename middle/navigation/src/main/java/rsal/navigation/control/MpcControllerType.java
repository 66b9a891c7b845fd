package rsal.navigation.control;

import rsal.navigation.avoid.Controller;
import rsal.navigation.mpc.Mpc;
import rsal.settings.Arguments;

/// Makes controllers by [Mpc].
public final class MpcControllerType implements ControllerType {
    @Override
    public String key() {
        return "mpc";
    }

    @Override
    public String description() {
        return "Plans velocities some seconds ahead, between the predicted obstacles (model predictive control).";
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        return new Mpc(driven.footprint(), driven.limits(), Mpc.Settings.DEFAULT, driven.reaction(), driven.period());
    }
}
