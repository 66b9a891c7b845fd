/// Frames of words and arrays, by which a process in Python and one in Java talk over pipes ([FramePipe]).
@NullMarked
package rsal.frame;

import org.jspecify.annotations.NullMarked;
