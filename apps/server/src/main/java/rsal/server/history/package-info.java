/// What a run was like before: for viewers who look back, live and in recordings.
@NullMarked
package rsal.server.history;

import org.jspecify.annotations.NullMarked;
