/// Frames: what is seen of a run at one moment, packed for many viewers.
@NullMarked
package rsal.server.frame;

import org.jspecify.annotations.NullMarked;
