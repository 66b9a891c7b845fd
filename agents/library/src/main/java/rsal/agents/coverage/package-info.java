/// Teams that spread over places.
@NullMarked
package rsal.agents.coverage;

import org.jspecify.annotations.NullMarked;
