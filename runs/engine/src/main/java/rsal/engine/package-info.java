/// Runs under way: robots, devices and agents put together, driven, watched and measured.
@NullMarked
package rsal.engine;

import org.jspecify.annotations.NullMarked;
