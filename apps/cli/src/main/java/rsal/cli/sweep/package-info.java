/// Commands for sweeps: to start one, and to report its results.
@NullMarked
package rsal.cli.sweep;

import org.jspecify.annotations.NullMarked;
