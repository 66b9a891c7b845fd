/// Cameras: what robots see in color, and how far away it is.
@NullMarked
package rsal.device.camera;

import org.jspecify.annotations.NullMarked;
