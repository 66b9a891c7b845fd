/// Reads maps as robots use them (ROS map files: YAML beside a PNG or PGM image), those that come with the program
/// and a person's own.
@NullMarked
package rsal.map;

import org.jspecify.annotations.NullMarked;
