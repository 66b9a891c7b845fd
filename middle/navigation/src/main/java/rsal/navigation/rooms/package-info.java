/// Rooms, corridors and gates of a map, found by how far its walls are apart.
@NullMarked
package rsal.navigation.rooms;

import org.jspecify.annotations.NullMarked;
