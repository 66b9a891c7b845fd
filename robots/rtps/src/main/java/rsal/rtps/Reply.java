package rsal.rtps;

import java.util.Optional;
import java.util.function.Consumer;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.ParameterList;

/// A sample that one participant waits for.
///
/// @param to who asked: one of its readers, or where that is unknown, one of its writers
/// @param timestamp [ns] since 1970
/// @param inlineQos writes what goes beside it, without an end; at most 128 B
/// @param payload with its encapsulation header; not changed any more
public record Reply(Guid to, long timestamp, Optional<Consumer<ParameterList.Writer>> inlineQos, byte[] payload) {}
