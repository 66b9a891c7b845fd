/// Time is handed in: what time it is, and which code runs when.
@NullMarked
package rsal.time;

import org.jspecify.annotations.NullMarked;
