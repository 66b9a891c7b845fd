/// Worlds of our own, `NAME.world.yaml`: read into scenes, and written from scenes of any format.
@NullMarked
package rsal.scene.yaml;

import org.jspecify.annotations.NullMarked;
