/// The geometry of a simulated world: walls, outlines of robots, rays, and motion that ends where things touch.
/// Places are in the map frame [m], headings in [rad].
@NullMarked
package rsal.sim.world;

import org.jspecify.annotations.NullMarked;
