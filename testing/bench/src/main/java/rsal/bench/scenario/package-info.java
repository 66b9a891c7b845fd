/// Benchmarks of scenarios over many seeds.
@NullMarked
package rsal.bench.scenario;

import org.jspecify.annotations.NullMarked;
