/// Programs that do without RSAL what benchmarks measure with it: in Java alone, on JADE, on Jason.
@NullMarked
package rsal.bench.bare;

import org.jspecify.annotations.NullMarked;
