package rsal.navigation.scanmatch;

import rsal.data.Covariance2d;
import rsal.data.Pose2d;

/// How a scan lies to what it was matched with.
///
/// @param covariance of x, y and heading in the frame `a`; large along what has no structure, like a corridor
/// @param score how much of the scan found its like, 0–1; see who made it
public record Match(Pose2d aFromB, Covariance2d covariance, double score) {}
