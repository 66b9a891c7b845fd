/// A Player server: ports, clients, what each is sent and when. Knows devices by what they answer only.
package rsal.player.server;
