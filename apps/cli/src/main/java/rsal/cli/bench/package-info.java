/// `rsal bench`: the benchmarks, with their progress and their page.
@NullMarked
package rsal.cli.bench;

import org.jspecify.annotations.NullMarked;
