package rsal.bare;

import java.time.Duration;

/// What agents of a [BareSystem] do, all alike.
///
/// @param period after which each says its pose to all others, again and again; zero for those that say nothing by
/// themselves
/// @param begun told by each that it has begun, on its own thread
/// @param heard told of each message that one hears, on that one's thread
public record Life(Duration period, Runnable begun, Runnable heard) {}
