/// Robots that drive in formation.
@NullMarked
package rsal.agents.formation;

import org.jspecify.annotations.NullMarked;
