package rsal.navigation.rooms;

import rsal.data.Point2d;

/// Where one gets from one region of a map to another: a door, or where walls come close.
///
/// @param number from 0
/// @param one number of a region
/// @param other number of another, always greater
/// @param middle in the map frame [m]
/// @param width diameter of the largest disc that passes between the walls [m], up to a cell less than between
/// walls
/// @param from one end of the border between the regions, beside a wall, in the map frame [m]
/// @param to its other end
public record RoomGate(int number, int one, int other, Point2d middle, double width, Point2d from, Point2d to) {
    public boolean leadsTo(int region) {
        return one == region || other == region;
    }

    /// The region on the other side.
    ///
    /// @param region one of the two
    public int across(int region) {
        return region == one ? other : one;
    }
}
