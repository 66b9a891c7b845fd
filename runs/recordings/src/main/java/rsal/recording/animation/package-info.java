/// Recorded runs as pictures that move, for pages that play nothing else.
@NullMarked
package rsal.recording.animation;

import org.jspecify.annotations.NullMarked;
