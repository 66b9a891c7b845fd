/// Images as walls are drawn in: which of their pixels are solid.
@NullMarked
package rsal.image;

import org.jspecify.annotations.NullMarked;
