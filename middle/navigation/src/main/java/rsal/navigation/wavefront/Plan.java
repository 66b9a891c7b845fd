package rsal.navigation.wavefront;

import rsal.data.Path2d;

/// What planning came to.
public sealed interface Plan {
    /// @param cost length of the way [m], more where it leads near obstacles
    record Found(Path2d path, double cost) implements Plan {}

    record None(String why) implements Plan {}
}
