/// Worlds as files: the contract of file formats, and what is checked and drawn of a world.
@NullMarked
package rsal.world;

import org.jspecify.annotations.NullMarked;
