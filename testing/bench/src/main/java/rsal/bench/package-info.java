/// All benchmarks, by area.
@NullMarked
package rsal.bench;

import org.jspecify.annotations.NullMarked;
