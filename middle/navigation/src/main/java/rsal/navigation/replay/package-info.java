/// Localization along recorded data, and how wrong it was.
@NullMarked
package rsal.navigation.replay;

import org.jspecify.annotations.NullMarked;
