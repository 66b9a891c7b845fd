/// What every algorithm on a map needs: how far the next obstacle is from each cell, and how far one sees.
@NullMarked
package rsal.navigation.grid;

import org.jspecify.annotations.NullMarked;
