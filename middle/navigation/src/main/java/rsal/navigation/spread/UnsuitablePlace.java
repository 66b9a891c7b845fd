package rsal.navigation.spread;

import rsal.data.Point2d;

/// A place that was given and won't do.
///
/// @param index which of those given it is, from 0
/// @param why in words, with the nearest place that will do
public record UnsuitablePlace(int index, Point2d place, Reason reason, String why) {
    public enum Reason {
        /// It is not on the map, or not a place at all.
        OUTSIDE,
        /// It is in a wall.
        OCCUPIED,
        /// The map knows nothing there.
        UNKNOWN,
        /// Something that is not free is nearer than the clearance.
        TOO_NEAR,
        /// No way leads there from the other places.
        CUT_OFF
    }
}
