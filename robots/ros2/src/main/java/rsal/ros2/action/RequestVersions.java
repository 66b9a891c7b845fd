package rsal.ros2.action;

import java.util.List;
import java.util.stream.Stream;
import rsal.ros2.cdr.CdrReader;
import rsal.ros2.cdr.InvalidCdr;
import rsal.ros2.cdr.MessageCodec;
import rsal.ros2.cdr.RosMessage;
import rsal.ros2.link.Inbox;
import rsal.ros2.type.Distribution;
import rsal.ros2.type.TypeLibrary;

/// Reads requests that distributions define differently, with fields in the middle that others do not have. Clients do
/// not tell which one they have: it is the one whose definition fits a request from the first to the last byte.
public final class RequestVersions implements Inbox.Decoder<RosMessage> {
    private static final int FILLING = 4; // bytes: some writers fill up to a multiple of it

    private final List<MessageCodec> codecs;

    private RequestVersions(List<MessageCodec> codecs) {
        this.codecs = codecs;
    }

    /// @param type of the service: `nav2_msgs/action/ComputePathToPose_SendGoal`
    public static RequestVersions of(String type) {
        return new RequestVersions(Stream.of(Distribution.JAZZY, Distribution.KILTED, Distribution.LYRICAL)
                .map(TypeLibrary::of)
                .map(types -> MessageCodec.of(types.get(type + "_Request"), types))
                .toList());
    }

    @Override
    public RosMessage read(CdrReader bytes) throws InvalidCdr {
        for (MessageCodec codec : codecs) {
            CdrReader reader = bytes.copy();
            try {
                RosMessage message = codec.read(reader);
                if (reader.isAtEnd(FILLING)) {
                    return message;
                }
            } catch (InvalidCdr _) {
                // maybe it is of another distribution
            }
        }
        throw new InvalidCdr("A request fits no definition of '%s'."
                .formatted(codecs.getFirst().type().name()));
    }
}
