package rsal.navigation.wavefront;

import rsal.data.Path2d;

/// What planning came to.
public sealed interface Plan {
    /// @param cost length of the way [m], more where it leads near obstacles
    /// @param offGoal how far from the goal it ends, since the robot can't be there [m]; 0 when it can
    record Found(Path2d path, double cost, double offGoal) implements Plan {}

    record None(String why) implements Plan {}
}
