/// Traffic of several robots: which of them goes first where two cannot pass, and where the others wait. Robots agree
/// by messages among themselves, or one of them plans for all.
@NullMarked
package rsal.navigation.traffic;

import org.jspecify.annotations.NullMarked;
