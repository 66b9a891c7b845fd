package rsal.model;

import java.util.List;

/// Colors of robots for which nobody chose one: told apart by the color-blind, too (Okabe and Ito 2008).
public final class RobotColors {
    private static final List<String> COLORS =
            List.of("#d55e00", "#0072b2", "#009e73", "#cc79a7", "#e69f00", "#56b4e9", "#f0e442");

    private RobotColors() {}

    /// `#rrggbb`.
    ///
    /// @param role number of the robot's role, from 0
    public static String of(int role) {
        return COLORS.get(Math.floorMod(role, COLORS.size()));
    }
}
