package rsal.navigation.control;

import java.util.List;
import java.util.Optional;
import rsal.navigation.avoid.Controller;
import rsal.navigation.vfh.Vfh;
import rsal.settings.Arguments;
import rsal.settings.Parameter;

/// Makes controllers by [Vfh].
public final class VfhControllerType implements ControllerType {
    @Override
    public String key() {
        return "vfh";
    }

    @Override
    public String description() {
        return "Steers to the best opening in a polar histogram of the obstacles around (VFH+), as Player's vfh does.";
    }

    @Override
    public List<Parameter<?>> parameters() {
        return VfhOptions.parameters();
    }

    @Override
    public Optional<String> refusal(Arguments arguments) {
        return VfhOptions.refusal(arguments);
    }

    @Override
    public double view(Arguments arguments, Driven driven) {
        double least = driven.lookahead() + 2 * driven.footprint().circumscribedRadius();
        return VfhOptions.window(arguments, least) + least;
    }

    @Override
    public Controller create(Arguments arguments, Driven driven) {
        return new Vfh(
                driven.footprint(),
                driven.limits(),
                VfhOptions.settings(arguments, driven.lookahead()),
                driven.reaction());
    }
}
