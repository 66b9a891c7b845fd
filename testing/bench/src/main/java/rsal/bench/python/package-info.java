/// How fast agents and learning environments in Python are.
@NullMarked
package rsal.bench.python;

import org.jspecify.annotations.NullMarked;
