/// How Player's messages look on the wire: headers, and bodies in XDR (RFC 4506) with Player's rules for arrays.
/// Knows no message.
package rsal.player.wire;
