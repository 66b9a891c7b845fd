/// Viewers on WebSockets, and what they are shown of a run or a recording.
@NullMarked
package rsal.server.live;

import org.jspecify.annotations.NullMarked;
