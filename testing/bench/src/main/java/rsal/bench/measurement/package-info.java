/// How benchmarks measure, compare and plot.
@NullMarked
package rsal.bench.measurement;

import org.jspecify.annotations.NullMarked;
