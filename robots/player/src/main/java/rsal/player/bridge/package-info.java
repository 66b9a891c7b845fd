/// Devices of robots as Player's clients know them. What comes from a client is done on the scheduler's thread, where
/// devices live.
package rsal.player.bridge;
