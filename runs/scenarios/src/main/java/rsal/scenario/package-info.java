/// Scenarios as people write them, and the plans they become: everything checked and decided, nothing started.
@NullMarked
package rsal.scenario;

import org.jspecify.annotations.NullMarked;
