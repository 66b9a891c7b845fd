/// Devices of Player servers as devices of ours.
package rsal.player.device;
