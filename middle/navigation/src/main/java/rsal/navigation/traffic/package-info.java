/// Traffic of several robots: which of them goes first where two cannot pass, and where the others wait. Robots agree
/// by messages among themselves.
@NullMarked
package rsal.navigation.traffic;

import org.jspecify.annotations.NullMarked;
