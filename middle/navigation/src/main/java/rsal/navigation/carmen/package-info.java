/// Logs of the robot toolkit CARMEN, in which many public data sets of lasers and odometry are kept, as values.
@NullMarked
package rsal.navigation.carmen;

import org.jspecify.annotations.NullMarked;
