/// Worlds of our own, `NAME.world.yaml`: read into scenes, and written from scenes of any format.
@NullMarked
package rsal.world.yaml;

import org.jspecify.annotations.NullMarked;
