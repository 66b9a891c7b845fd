/// Benchmarks of agent platforms, beside bare programs that do the same without RSAL.
@NullMarked
package rsal.bench.mas;

import org.jspecify.annotations.NullMarked;
