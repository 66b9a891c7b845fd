/// Immutable values that a run reports: snapshots, events, answers, metrics, results.
@NullMarked
package rsal.engine.report;

import org.jspecify.annotations.NullMarked;
