/// XML as robots and worlds of others are written in: elements with their places, and where frames are in space.
@NullMarked
package rsal.model.xml;

import org.jspecify.annotations.NullMarked;
