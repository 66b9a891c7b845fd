package rsal.navigation.explore;

import rsal.data.Point2d;

/// A stretch of free cells beside unknown ones, where a robot learns more when it goes there.
///
/// @param place of the cell of it that is nearest to its middle
/// @param length of it in meters
public record Frontier(Point2d place, double length) {}
