/// Immutable values in SI units and radians, axes after REP 103 (x forward, y left, angles counter-clockwise),
/// frames after REP 105 (`map → odom → base_link`), ranges after REP 117. Arrays inside a record are handed over:
/// the one that made the record does not write to them again, and those that read them do not either.
@NullMarked
package rsal.data;

import org.jspecify.annotations.NullMarked;
