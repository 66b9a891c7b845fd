/// Recordings of runs: what of a run is written, and what is read of it again.
@NullMarked
package rsal.recording;

import org.jspecify.annotations.NullMarked;
