package rsal.sim.world;

/// What sensors and others make of something solid.
///
/// @param rgb color, `0xRRGGBB`
/// @param obstacle whether robots run into it
/// @param intensity how strongly it reflects what range sensors send; negative when they look through it
public record Surface(int rgb, boolean obstacle, double intensity) {
    /// Gray, in everybody's way, seen by all.
    public static final Surface PLAIN = new Surface(0x808080, true, 1);

    boolean seenByRangers() {
        return intensity >= 0;
    }
}
