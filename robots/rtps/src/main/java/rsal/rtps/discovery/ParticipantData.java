package rsal.rtps.discovery;

import static rsal.rtps.wire.ParameterId.BUILTIN_ENDPOINT_SET;
import static rsal.rtps.wire.ParameterId.DEFAULT_UNICAST_LOCATOR;
import static rsal.rtps.wire.ParameterId.DOMAIN_ID;
import static rsal.rtps.wire.ParameterId.DOMAIN_TAG;
import static rsal.rtps.wire.ParameterId.ENTITY_NAME;
import static rsal.rtps.wire.ParameterId.METATRAFFIC_UNICAST_LOCATOR;
import static rsal.rtps.wire.ParameterId.PARTICIPANT_GUID;
import static rsal.rtps.wire.ParameterId.PARTICIPANT_LEASE_DURATION;
import static rsal.rtps.wire.ParameterId.PROTOCOL_VERSION;
import static rsal.rtps.wire.ParameterId.USER_DATA;
import static rsal.rtps.wire.ParameterId.VENDOR_ID;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.GuidPrefix;
import rsal.rtps.wire.InvalidRtps;
import rsal.rtps.wire.Locator;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Timestamp;

/// What a participant announces of itself (SPDP).
///
/// @param domain empty where it does not say
/// @param domainTag empty for none
/// @param builtinEndpoints bits of [BuiltinEndpoint]
/// @param lease [ns] after which it is gone, unless it announces itself again
/// @param metatraffic where its built-in readers and writers receive
/// @param userTraffic where all others receive that say nothing else
/// @param name for people; empty for none
/// @param userData for ROS, `enclave=/;`
public record ParticipantData(
        GuidPrefix prefix,
        Optional<Integer> domain,
        String domainTag,
        int builtinEndpoints,
        long lease,
        List<Locator> metatraffic,
        List<Locator> userTraffic,
        String name,
        String userData) {
    private static final long DEFAULT_LEASE = 100_000_000_000L; // ns, of the standard
    private static final int MOST_LOCATORS = 16;

    public ParticipantData {
        metatraffic = List.copyOf(metatraffic);
        userTraffic = List.copyOf(userTraffic);
    }

    /// @throws InvalidRtps when it does not say who it is
    public static ParticipantData of(ParameterList list) throws InvalidRtps {
        Guid guid = list.find(PARTICIPANT_GUID, Guid.BYTES)
                .map(Guid::read)
                .orElseThrow(() -> new InvalidRtps("A participant does not say its GUID."));
        return new ParticipantData(
                guid.prefix(),
                list.find(DOMAIN_ID, Integer.BYTES).map(ByteBuffer::getInt),
                list.text(DOMAIN_TAG).orElse(""),
                list.find(BUILTIN_ENDPOINT_SET, Integer.BYTES)
                        .map(ByteBuffer::getInt)
                        .orElse(0),
                list.find(PARTICIPANT_LEASE_DURATION, Timestamp.BYTES)
                        .map(Timestamp::readDuration)
                        .orElse(DEFAULT_LEASE),
                locators(list, METATRAFFIC_UNICAST_LOCATOR),
                locators(list, DEFAULT_UNICAST_LOCATOR),
                list.text(ENTITY_NAME).orElse(""),
                list.octets(USER_DATA).orElse(""));
    }

    static List<Locator> locators(ParameterList list, int id) {
        return list.all(id, Locator.BYTES)
                .map(Locator::read)
                .limit(MOST_LOCATORS)
                .toList();
    }

    /// Without its end.
    public void write(ParameterList.Writer list) {
        list.put(PROTOCOL_VERSION, to -> to.put((byte) 2).put((byte) 3));
        list.put(VENDOR_ID, to -> to.put((byte) (prefix.vendor() >> 8)).put((byte) prefix.vendor()));
        list.put(PARTICIPANT_GUID, new Guid(prefix, EntityId.PARTICIPANT)::write);
        list.putInt(BUILTIN_ENDPOINT_SET, builtinEndpoints);
        list.put(PARTICIPANT_LEASE_DURATION, to -> Timestamp.writeDuration(to, lease));
        domain.ifPresent(number -> list.putInt(DOMAIN_ID, number));
        metatraffic.forEach(locator -> list.put(METATRAFFIC_UNICAST_LOCATOR, locator::write));
        userTraffic.forEach(locator -> list.put(DEFAULT_UNICAST_LOCATOR, locator::write));
        if (!name.isEmpty()) {
            list.putText(ENTITY_NAME, name);
        }
        list.putOctets(USER_DATA, userData);
    }
}
