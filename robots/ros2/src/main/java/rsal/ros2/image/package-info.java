/// Images of cameras, plain and compressed.
@NullMarked
package rsal.ros2.image;

import org.jspecify.annotations.NullMarked;
