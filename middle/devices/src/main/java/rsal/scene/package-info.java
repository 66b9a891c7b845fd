/// What a world is like before anything moves in it: walls, things and robots, as told by a map or a world file,
/// no matter what simulates it. Values only.
@NullMarked
package rsal.scene;

import org.jspecify.annotations.NullMarked;
