/// Multi-agent systems without us, for benchmarks to hold our hosts against: modules that may use a system provide it.
@NullMarked
package rsal.bare;

import org.jspecify.annotations.NullMarked;
