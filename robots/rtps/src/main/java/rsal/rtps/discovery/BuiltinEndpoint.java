package rsal.rtps.discovery;

import java.util.List;
import rsal.rtps.wire.EntityId;

/// Writers by which participants tell of their endpoints and of being alive, each with its reader: bits of
/// [ParticipantData#builtinEndpoints] (DDSI-RTPS 2.5, table 9.4).
///
/// @param writerBit of the set, where a participant has this writer
/// @param readerBit where it has this reader
public record BuiltinEndpoint(EntityId writer, EntityId reader, int writerBit, int readerBit) {
    public static final BuiltinEndpoint PUBLICATIONS =
            new BuiltinEndpoint(EntityId.PUBLICATION_WRITER, EntityId.PUBLICATION_READER, 1 << 2, 1 << 3);
    public static final BuiltinEndpoint SUBSCRIPTIONS =
            new BuiltinEndpoint(EntityId.SUBSCRIPTION_WRITER, EntityId.SUBSCRIPTION_READER, 1 << 4, 1 << 5);
    public static final BuiltinEndpoint LIVELINESS =
            new BuiltinEndpoint(EntityId.LIVELINESS_WRITER, EntityId.LIVELINESS_READER, 1 << 10, 1 << 11);

    public static final List<BuiltinEndpoint> RELIABLE = List.of(PUBLICATIONS, SUBSCRIPTIONS, LIVELINESS);

    /// All of these, and the announcement of participants.
    public static final int ALL = 0b11
            | RELIABLE.stream()
                    .mapToInt(each -> each.writerBit | each.readerBit)
                    .reduce(0, (all, bits) -> all | bits);
}
