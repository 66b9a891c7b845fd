/// Benchmarks of robot systems: the simulator, and robots over the network.
@NullMarked
package rsal.bench.robots;

import org.jspecify.annotations.NullMarked;
