/// Adaptive Monte Carlo localization: where a robot is on a map, from odometry and ranges.
@NullMarked
package rsal.navigation.amcl;

import org.jspecify.annotations.NullMarked;
