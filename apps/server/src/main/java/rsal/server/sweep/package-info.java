/// Sweeps that are begun in the page.
@NullMarked
package rsal.server.sweep;

import org.jspecify.annotations.NullMarked;
