/// The format of logs of the robot toolkit CARMEN, in which many public data sets of lasers and odometry are kept.
@NullMarked
package rsal.navigation.carmen;

import org.jspecify.annotations.NullMarked;
