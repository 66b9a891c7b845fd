package rsal.navigation.spread;

/// How far it is from anywhere on a [ReachableSpace] to the nearest of some places, by the shortest way [m].
///
/// @param mean how far it is on average: the objective of k-medians
/// @param rms root of the mean square: the objective of k-means, and the one that [Spread] makes small. The far
/// away counts for more, so that no room is left to a place in the next one for the sake of a wide hall
/// @param greatest from where it is farthest: the objective of k-centers
public record Evenness(double mean, double rms, double greatest) {}
