/// What samples say about what they are from, and how sure that is.
@NullMarked
package rsal.experiment.statistics;

import org.jspecify.annotations.NullMarked;
