package rsal.rtps;

import java.util.Optional;
import java.util.function.Consumer;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Submessage.Content;

/// A sample that a writer keeps for those who lack it.
///
/// @param number from 1 on
/// @param timestamp when it was written [ns] since 1970
/// @param inlineQos writes what goes beside it, without an end; empty for nothing
/// @param payload with its encapsulation header; not changed any more
record KeptSample(
        long number,
        long timestamp,
        Optional<Consumer<ParameterList.Writer>> inlineQos,
        Content content,
        byte[] payload) {}
