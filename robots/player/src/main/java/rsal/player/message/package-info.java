/// Player's messages by interface, as records that show what is sent in its order: lengths in m, angles in rad,
/// counterclockwise, unless told otherwise.
package rsal.player.message;
