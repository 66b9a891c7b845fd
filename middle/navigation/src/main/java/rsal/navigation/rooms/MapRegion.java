package rsal.navigation.rooms;

import rsal.data.Point2d;

/// A part of a floor between walls and gates.
///
/// @param number from 0, by its first cell, row by row from below
/// @param area of its free cells, without furniture [m²]
/// @param middle where it is farthest from walls and furniture, in the map frame [m]
/// @param clearance how far the next cell that is not free is from there [m]
public record MapRegion(int number, RegionKind kind, double area, Point2d middle, double clearance) {}
