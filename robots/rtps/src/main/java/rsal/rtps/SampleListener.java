package rsal.rtps;

import java.nio.ByteBuffer;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.ParameterList;

/// Gets the samples of a reader, those of one writer in order, each once. Called while the participant is locked: be
/// quick. It may write samples, and nothing else of the participant.
public interface SampleListener {
    /// @param sample valid during the call only
    void onSample(Sample sample);

    /// Whether it takes another sample. Asked of reliable readers that keep all
    /// ([rsal.rtps.discovery.Qos#KEEP_ALL]): what they do not take they do not acknowledge, so that writers
    /// that keep all wait. When it takes some again, it says so by [Participant#resume] or
    /// [UdpParticipant#resume], not while it is called.
    default boolean hasRoom() {
        return true;
    }

    /// @param writer who wrote it
    /// @param number of this writer's samples, from 1 on
    /// @param timestamp when it was written [ns] since 1970; −1 where the writer does not say
    /// @param inlineQos what came beside it
    /// @param payload with its encapsulation header, from position to limit
    record Sample(Guid writer, long number, long timestamp, ParameterList inlineQos, ByteBuffer payload) {}
}
