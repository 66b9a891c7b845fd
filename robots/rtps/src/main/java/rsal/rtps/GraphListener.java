package rsal.rtps;

import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;

/// Hears who and what is on the network. Called while the participant is locked: be quick, and call nothing of it.
public interface GraphListener {
    GraphListener NONE = new GraphListener() {};

    /// A participant is there that was not before.
    default void onParticipant(ParticipantData participant) {}

    /// A participant has left, or its lease has ended. Its writers and readers are gone, too.
    default void onParticipantLost(GuidPrefix participant) {}

    /// A participant has a writer or reader, or has changed it.
    default void onEndpoint(EndpointData endpoint) {}

    default void onEndpointLost(Guid endpoint) {}

    /// A writer and a reader of one topic don't fit together.
    ///
    /// @param why for people: what differs, and who wants what
    default void onMismatch(EndpointData own, EndpointData other, String why) {}
}
