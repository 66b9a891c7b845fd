/// Runs side by side, and what can be asked of and told to them over HTTP.
@NullMarked
package rsal.server.run;

import org.jspecify.annotations.NullMarked;
