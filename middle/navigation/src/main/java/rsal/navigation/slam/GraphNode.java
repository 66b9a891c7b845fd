package rsal.navigation.slam;

import rsal.data.LaserScan;
import rsal.data.Pose2d;
import rsal.navigation.scanmatch.Cloud;

/// A scan that was kept, a node of the graph.
///
/// @param odomFromBase what the wheels said
/// @param traveled way to here [m], as the wheels say
/// @param cloud what the scan hit, in the frame of the robot
record GraphNode(Pose2d odomFromBase, double traveled, LaserScan scan, Cloud cloud) {}
