/// Places and robots that several benchmarks use.
@NullMarked
package rsal.bench.place;

import org.jspecify.annotations.NullMarked;
