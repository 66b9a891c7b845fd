package rsal.rtps.wire;

import java.nio.ByteBuffer;

/// A part of a message that says one thing (DDSI-RTPS 2.5, 8.3.8). What readers skip has no class here.
public sealed interface Submessage {
    EntityId reader();

    EntityId writer();

    /// A reader has all samples below the base, and lacks those in the set.
    ///
    /// @param missing its base is 0 where the reader knows nothing yet
    /// @param count grows with each
    /// @param isFinal whether no heartbeat has to follow
    record AckNack(EntityId reader, EntityId writer, NumberSet missing, int count, boolean isFinal)
            implements Submessage {}

    /// A writer has these samples.
    ///
    /// @param last one less than the first where it has none
    /// @param isFinal whether readers that lack nothing need not answer
    record Heartbeat(EntityId reader, EntityId writer, long first, long last, int count, boolean isFinal)
            implements Submessage {}

    /// Samples from the start up to the set's base, and those in it, do not come.
    record Gap(EntityId reader, EntityId writer, long start, NumberSet more) implements Submessage {}

    /// What the payload of a sample is.
    enum Content {
        NONE,
        DATA,
        /// Only the key of what is removed.
        KEY
    }

    /// A sample.
    ///
    /// @param inlineQos parts of the message, as the payload: copied by all who keep them
    /// @param payload with its encapsulation header, from position to limit
    record Data(
            EntityId reader, EntityId writer, long number, ParameterList inlineQos, Content content, ByteBuffer payload)
            implements Submessage {}

    /// Some fragments of a sample, which follow each other.
    ///
    /// @param first number of the first, from 1 on
    /// @param fragmentSize [B] of each but the sample's last
    /// @param sampleSize [B] with the encapsulation header
    /// @param part bytes of these fragments, parts of the message
    record DataFragments(
            EntityId reader,
            EntityId writer,
            long number,
            ParameterList inlineQos,
            int first,
            int count,
            int fragmentSize,
            int sampleSize,
            ByteBuffer part)
            implements Submessage {}

    /// A reader lacks these fragments of a sample.
    record NackFragments(EntityId reader, EntityId writer, long number, NumberSet missing, int count)
            implements Submessage {}
}
