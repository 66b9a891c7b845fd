/// Recoveries: what a navigator does when the robot makes no progress or does not know where it is. Each is a
/// plugin, as behaviors of Nav2 are.
@NullMarked
package rsal.navigation.recovery;

import org.jspecify.annotations.NullMarked;
