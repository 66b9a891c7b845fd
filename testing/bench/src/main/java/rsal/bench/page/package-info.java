/// Benchmarks of the page in a browser.
@NullMarked
package rsal.bench.page;

import org.jspecify.annotations.NullMarked;
