/// Devices as agents see them. Each is one of four verbs: *latest* (what is it now), *subscribe* (tell me),
/// *command* (newest wins, and stops by itself when commands dry up), *goal* (takes a while, can be cancelled,
/// ends in one of a few named ways).
///
/// All calls and callbacks happen on the thread of the run's [rsal.time.Scheduler].
@NullMarked
package rsal.device;

import org.jspecify.annotations.NullMarked;
