/// Avoidance by the nearness diagram: what the robot sees as gaps and the regions between them.
@NullMarked
package rsal.navigation.nd;

import org.jspecify.annotations.NullMarked;
