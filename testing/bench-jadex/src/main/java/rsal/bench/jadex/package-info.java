/// Programs that do on Jadex without RSAL what benchmarks measure with it.
@NullMarked
package rsal.bench.jadex;

import org.jspecify.annotations.NullMarked;
