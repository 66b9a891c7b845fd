/// Benchmarks of localization, planning, control, mapping and exploration.
@NullMarked
package rsal.bench.navigation;

import org.jspecify.annotations.NullMarked;
