package rsal.sim.world;

import rsal.data.Footprint;
import rsal.data.Pose2d;

/// A robot as the world knows it: an outline with a name.
public final class Body {
    final int index; // in the world's list
    final Outline outline;
    final Outline trial; // where it might go
    final Outline seen; // where it was when sensors last looked
    private final String name;

    Body(int index, String name, Footprint footprint, Pose2d mapFromBase) {
        this.index = index;
        this.name = name;
        outline = new Outline(footprint);
        trial = new Outline(footprint);
        seen = new Outline(footprint);
        outline.placeAt(mapFromBase);
        seen.placeAt(mapFromBase);
    }

    public String name() {
        return name;
    }

    /// Where it is: mapFromBase.
    public Pose2d pose() {
        return outline.pose();
    }

    /// Where sensors see it: mapFromBase at the last [World#look].
    public Pose2d seenPose() {
        return seen.pose();
    }
}
