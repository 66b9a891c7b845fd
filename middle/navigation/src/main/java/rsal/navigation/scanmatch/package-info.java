/// How a scan lies to another or to a map: a search over a window that misses nothing, then lines fitted to
/// points.
@NullMarked
package rsal.navigation.scanmatch;

import org.jspecify.annotations.NullMarked;
