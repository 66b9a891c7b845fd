/// Agents in Python: their files, the process in which they live, and how both sides exchange what is said.
@NullMarked
package rsal.python;

import org.jspecify.annotations.NullMarked;
