package rsal.navigation.slam;

import rsal.data.Pose2d;

/// What became of two maps that were to be one.
public sealed interface Merge {
    /// They are one now.
    ///
    /// @param mapFromOther where the frame of the other's map came to be
    /// @param shared what the two have in common there
    record Done(Pose2d mapFromOther, MapOverlap shared) implements Merge {}

    /// They fit in two ways about as well, as halves of a building do that look alike; they stay two.
    ///
    /// @param mapFromOther where the frame of the other's map may be
    /// @param rival where else it may be
    record Ambiguous(Pose2d mapFromOther, Pose2d rival) implements Merge {}

    /// They fit in one way, but what one saw there contradicts what the other did; they stay two.
    ///
    /// @param mapFromOther where the frame of the other's map would be
    /// @param shared what the two would have in common there
    record Contradicted(Pose2d mapFromOther, MapOverlap shared) implements Merge {}

    /// Nothing tells that they share a place; they stay two.
    record Apart() implements Merge {}
}
