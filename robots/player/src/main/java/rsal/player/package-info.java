/// The robot system `player`.
package rsal.player;
