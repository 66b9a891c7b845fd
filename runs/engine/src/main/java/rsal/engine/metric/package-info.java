/// What a run measures for conditions and results.
@NullMarked
package rsal.engine.metric;

import org.jspecify.annotations.NullMarked;
