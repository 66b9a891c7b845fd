/// Avoidance by looking ahead: a rolling map of what was seen, the time that the way takes from each place of it,
/// and the best of many drives of the next seconds.
@NullMarked
package rsal.navigation.mpc;

import org.jspecify.annotations.NullMarked;
