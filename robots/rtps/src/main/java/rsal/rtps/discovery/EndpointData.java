package rsal.rtps.discovery;

import static rsal.rtps.wire.ParameterId.DATA_REPRESENTATION;
import static rsal.rtps.wire.ParameterId.DEADLINE;
import static rsal.rtps.wire.ParameterId.DURABILITY;
import static rsal.rtps.wire.ParameterId.ENDPOINT_GUID;
import static rsal.rtps.wire.ParameterId.HISTORY;
import static rsal.rtps.wire.ParameterId.LIVELINESS;
import static rsal.rtps.wire.ParameterId.PARTICIPANT_GUID;
import static rsal.rtps.wire.ParameterId.RELIABILITY;
import static rsal.rtps.wire.ParameterId.TOPIC_NAME;
import static rsal.rtps.wire.ParameterId.TYPE_NAME;
import static rsal.rtps.wire.ParameterId.UNICAST_LOCATOR;
import static rsal.rtps.wire.ParameterId.USER_DATA;

import java.nio.ByteBuffer;
import java.util.List;
import java.util.Optional;
import rsal.rtps.wire.EntityId;
import rsal.rtps.wire.Guid;
import rsal.rtps.wire.InvalidRtps;
import rsal.rtps.wire.Locator;
import rsal.rtps.wire.ParameterList;
import rsal.rtps.wire.Timestamp;

/// What a participant tells of one of its writers or readers (SEDP).
///
/// @param topic as DDS names it: `rt/scan` for ROS's `/scan`
/// @param type as DDS names it: `sensor_msgs::msg::dds_::LaserScan_`
/// @param locators where it receives; empty for where its participant does
/// @param userData for ROS, `typehash=…;`
public record EndpointData(Guid guid, String topic, String type, Qos qos, List<Locator> locators, String userData) {
    private static final int BEST_EFFORT = 1;
    private static final int RELIABLE = 2;
    private static final int KEEP_LAST = 0;
    private static final int KEEP_ALL = 1;
    private static final int LONGEST = 1_024; // characters; names of ROS have 255 at most

    public EndpointData {
        locators = List.copyOf(locators);
    }

    /// @param isWriter writers are reliable and readers best effort where they don't say
    /// @throws InvalidRtps also when a name is longer than 1,024 characters
    public static EndpointData of(ParameterList list, boolean isWriter) throws InvalidRtps {
        return new EndpointData(
                list.find(ENDPOINT_GUID, Guid.BYTES).map(Guid::read).orElseThrow(() -> lacks("GUID")),
                name(list, TOPIC_NAME).orElseThrow(() -> lacks("topic")),
                name(list, TYPE_NAME).orElseThrow(() -> lacks("type")),
                qos(list, isWriter),
                ParticipantData.locators(list, UNICAST_LOCATOR),
                list.octets(USER_DATA).filter(data -> data.length() <= LONGEST).orElse(""));
    }

    private static Optional<String> name(ParameterList list, int parameter) throws InvalidRtps {
        Optional<String> name = list.text(parameter);
        if (name.isPresent() && name.get().length() > LONGEST) {
            throw new InvalidRtps(
                    "A name has %d characters.".formatted(name.get().length()));
        }
        return name;
    }

    private static InvalidRtps lacks(String what) {
        return new InvalidRtps("A writer or reader does not say its %s.".formatted(what));
    }

    private static Qos qos(ParameterList list, boolean isWriter) {
        Optional<Integer> reliability = list.find(RELIABILITY, Integer.BYTES).map(ByteBuffer::getInt);
        Optional<ByteBuffer> history = list.find(HISTORY, 2 * Integer.BYTES);
        return new Qos(
                reliability.map(kind -> kind == RELIABLE).orElse(isWriter),
                list.find(DURABILITY, Integer.BYTES)
                        .map(kind -> kind.getInt() > 0)
                        .orElse(false),
                history.map(kind -> kind.getInt() == KEEP_ALL ? Qos.KEEP_ALL : Math.max(1, kind.getInt()))
                        .orElse(1),
                list.find(DEADLINE, Timestamp.BYTES)
                        .map(Timestamp::readDuration)
                        .orElse(Timestamp.INFINITE),
                list.find(LIVELINESS, Integer.BYTES + Timestamp.BYTES)
                        .map(value -> new Qos.Liveliness(value.getInt(), Timestamp.readDuration(value)))
                        .orElse(new Qos.Liveliness(Qos.Liveliness.AUTOMATIC, Timestamp.INFINITE)));
    }

    /// Without its end.
    public void write(ParameterList.Writer list) {
        list.put(ENDPOINT_GUID, guid::write);
        list.put(PARTICIPANT_GUID, new Guid(guid.prefix(), EntityId.PARTICIPANT)::write);
        list.putText(TOPIC_NAME, topic);
        list.putText(TYPE_NAME, type);
        list.put(RELIABILITY, to -> {
            to.putInt(qos.isReliable() ? RELIABLE : BEST_EFFORT);
            Timestamp.writeDuration(to, Qos.MAX_BLOCKING);
        });
        list.putInt(DURABILITY, qos.isLatched() ? 1 : 0);
        boolean all = qos.depth() == Qos.KEEP_ALL;
        list.put(HISTORY, to -> to.putInt(all ? KEEP_ALL : KEEP_LAST).putInt(all ? 0 : qos.depth()));
        if (qos.deadline() != Timestamp.INFINITE) {
            list.put(DEADLINE, to -> Timestamp.writeDuration(to, qos.deadline()));
        }
        list.put(LIVELINESS, to -> {
            to.putInt(qos.liveliness().kind());
            Timestamp.writeDuration(to, qos.liveliness().lease());
        });
        list.put(DATA_REPRESENTATION, to -> to.putInt(1).putShort((short) 0)); // XCDR1
        locators.forEach(locator -> list.put(UNICAST_LOCATOR, locator::write));
        if (!userData.isEmpty()) {
            list.putOctets(USER_DATA, userData);
        }
    }

    public boolean isWriter() {
        return guid.entity().isWriter();
    }

    /// Why a writer of this topic does not serve a reader of it; empty when it does.
    public Optional<String> mismatch(EndpointData reader) {
        return type.equals(reader.type)
                ? qos.mismatch(reader.qos)
                : Optional.of("type: the writer has '%s', the reader '%s'".formatted(type, reader.type));
    }
}
