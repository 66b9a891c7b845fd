/// A participant of a DDS domain: its writers and readers, those of others, and how samples get from one to the other.
/// [rsal.rtps.Participant] is the protocol without sockets, clocks and threads; [rsal.rtps.UdpParticipant] has them.
@NullMarked
package rsal.rtps;

import org.jspecify.annotations.NullMarked;
