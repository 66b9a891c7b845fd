/// Benchmarks of whole jobs.
@NullMarked
package rsal.bench;

import org.jspecify.annotations.NullMarked;
