package rsal.navigation.rooms;

/// What counts as a gate, a room, a corridor and furniture.
///
/// @param leastGate narrower openings are cracks in a wall, through which nobody passes [m]
/// @param gateWidth how wide a door may be [m]
/// @param narrowing how wide a door may be, as a share of the greatest width of the narrower side, 0 to 1
/// @param doorShare the same, of the wider side
/// @param openingShare how wide an opening that is no door may be, as a share of the greatest width of the
/// narrower side, 0 to 1
/// @param leastArea smaller regions join a neighbor, unless they are closets behind a door [m²]
/// @param closetArea smaller regions are closets [m²]
/// @param corridorLength how many times as long as wide a corridor is at least, if it has three or more gates;
/// with two gates half as much again
/// @param corridorWidth how wide a corridor is at most, on average [m]; a quarter more in its widest place
/// @param furnitureLength how long loose furniture is at most [m]; 0: none is looked for
public record RoomParameters(
        double leastGate,
        double gateWidth,
        double narrowing,
        double doorShare,
        double openingShare,
        double leastArea,
        double closetArea,
        double corridorLength,
        double corridorWidth,
        double furnitureLength) {
    public static final RoomParameters DEFAULT = new RoomParameters(0.3, 2.0, 0.85, 0.6, 0.4, 3, 4, 5.5, 4, 5);

    /// @throws IllegalArgumentException when one is out of its range
    public RoomParameters {
        check("leastGate", leastGate, 100);
        check("gateWidth", gateWidth, 100);
        check("narrowing", narrowing, 1);
        check("doorShare", doorShare, 1);
        check("openingShare", openingShare, 1);
        check("leastArea", leastArea, 1e4);
        check("closetArea", closetArea, 1e4);
        check("corridorLength", corridorLength, 1e4);
        check("corridorWidth", corridorWidth, 1e4);
        check("furnitureLength", furnitureLength, 100);
    }

    private static void check(String name, double value, double most) {
        if (!(value >= 0 && value <= most)) {
            throw new IllegalArgumentException(
                    "The parameter '%s' of rooms is '%s'. It must be from 0 to %s.".formatted(name, value, most));
        }
    }

    /// Whether the place where two parts of the floor meet divides them.
    ///
    /// @param saddle half the width there [m]
    /// @param lower half the greatest width of the narrower part [m]
    /// @param higher the same of the wider part
    boolean isGate(double saddle, double lower, double higher) {
        boolean isDoor = 2 * saddle <= gateWidth && saddle <= narrowing * lower && saddle <= doorShare * higher;
        return isDoor || saddle <= openingShare * lower;
    }
}
