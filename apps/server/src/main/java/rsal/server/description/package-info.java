/// Runs, robots and readings as the page's messages have them.
@NullMarked
package rsal.server.description;

import org.jspecify.annotations.NullMarked;
