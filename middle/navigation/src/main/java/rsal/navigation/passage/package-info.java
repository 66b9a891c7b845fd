/// Narrow passages of a map, in which two robots cannot pass each other: doors, corridors and chains of them, with
/// gates and places to wait.
@NullMarked
package rsal.navigation.passage;

import org.jspecify.annotations.NullMarked;
