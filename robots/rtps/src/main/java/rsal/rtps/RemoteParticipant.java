package rsal.rtps;

import java.nio.ByteBuffer;
import java.util.LinkedHashMap;
import java.util.Map;
import rsal.rtps.discovery.EndpointData;
import rsal.rtps.discovery.ParticipantData;
import rsal.rtps.wire.Guid;

/// Another participant, with the writers and readers that it has announced.
final class RemoteParticipant {
    private static final long LEAST_LEASE = 500_000_000; // ns
    private static final long MOST_LEASE = 3_600_000_000_000L;

    final ParticipantData data;
    final Addressee metatraffic;
    final Addressee userTraffic;
    final Map<Guid, EndpointData> endpoints = new LinkedHashMap<>();
    private ByteBuffer said = ByteBuffer.allocate(0); // the newest that it said of itself
    private long inGroupUntil = Long.MIN_VALUE; // [ns]
    long expiry; // when it is gone unless it announces itself again [ns]

    RemoteParticipant(ParticipantData data, Addressee metatraffic, Addressee userTraffic) {
        this.data = data;
        this.metatraffic = metatraffic;
        this.userTraffic = userTraffic;
    }

    /// Whether it is to be reached as before: networks give machines new addresses.
    boolean isWhereItWas(ParticipantData newest) {
        return newest.metatraffic().equals(data.metatraffic())
                && newest.userTraffic().equals(data.userTraffic());
    }

    /// @param payload of its announcement, used again afterwards
    void says(ByteBuffer payload) {
        said = ByteBuffer.allocate(payload.remaining()).put(payload.duplicate()).flip();
    }

    /// Whether that is what it said before, which need not be read again: most announcements are so.
    boolean hasSaid(ByteBuffer payload) {
        return said.hasRemaining() && said.equals(payload);
    }

    /// @param isToGroup whether it said so to the multicast group
    void isAlive(long now, boolean isToGroup) {
        expiry = now + lease();
        inGroupUntil = isToGroup ? expiry : inGroupUntil;
    }

    private long lease() {
        return Math.clamp(data.lease(), LEAST_LEASE, MOST_LEASE);
    }

    /// Whether the multicast group has carried an announcement of it within its lease.
    boolean isInGroup(long now) {
        return now < inGroupUntil;
    }
}
