/// Configuration files of Player servers (`.cfg`): their grammar, what their drivers provide, and the world that their
/// `stage` driver names.
@NullMarked
package rsal.stage.playercfg;

import org.jspecify.annotations.NullMarked;
