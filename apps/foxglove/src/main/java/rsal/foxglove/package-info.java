/// A server of the protocol that Foxglove speaks: github.com/foxglove/ws-protocol, "Foxglove WebSocket protocol
/// v1". [FoxgloveServer] shows runs, one after the other; each [Client] has its subscriptions; [FoxgloveAccess]
/// says who may come in, [PublishedGoal] what a client wants of a robot.
@NullMarked
package rsal.foxglove;

import org.jspecify.annotations.NullMarked;
