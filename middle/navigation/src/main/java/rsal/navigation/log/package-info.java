/// Logs of a robot's laser and odometry as values, in whatever format they are kept: a format is a
/// [rsal.navigation.log.LogFormat].
@NullMarked
package rsal.navigation.log;

import org.jspecify.annotations.NullMarked;
