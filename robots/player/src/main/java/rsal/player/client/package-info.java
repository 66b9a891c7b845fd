/// Connections to Player servers. Blocks on threads of its own only.
package rsal.player.client;
