package rsal.recording.proto;

import java.io.IOException;
import java.nio.ByteBuffer;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import rsal.recording.proto.MessageType.Field;
import rsal.recording.proto.MessageType.Kind;

/// Reads what describes a kind of messages, as [MessageType#descriptors] writes it: a
/// `google.protobuf.FileDescriptorSet`.
public final class Descriptors {
    private static final int DEEPEST = 10; // messages within messages
    private static final int REPEATED = 3;

    private static final MessageType FIELD = MessageType.named("descriptor.Field")
            .with(1, "name", Kind.STRING)
            .with(3, "number", Kind.INT32)
            .with(4, "label", Kind.INT32)
            .with(5, "type", Kind.INT32)
            .with(6, "type_name", Kind.STRING);
    private static final MessageType MESSAGE =
            MessageType.named("descriptor.Message").with(1, "name", Kind.STRING).withMany(2, "field", FIELD);
    private static final MessageType FILE =
            MessageType.named("descriptor.File").with(2, "package", Kind.STRING).withMany(4, "message_type", MESSAGE);
    private static final MessageType SET = MessageType.named("descriptor.Set").withMany(1, "file", FILE);

    private final Map<String, List<Map<String, Object>>> fields = new HashMap<>(); // by name of the message

    private Descriptors() {}

    /// @param name of the kind, with its package
    /// @return without fields of kinds that are not known here; empty when it is not described
    /// @throws IOException when these are no descriptors
    public static Optional<MessageType> read(byte[] descriptors, String name) throws IOException {
        var all = new Descriptors();
        for (Map<String, Object> file : many(ProtoReader.read(SET, ByteBuffer.wrap(descriptors)), "file")) {
            for (Map<String, Object> message : many(file, "message_type")) {
                all.fields.put(file.get("package") + "." + message.get("name"), many(message, "field"));
            }
        }
        return all.type(name, 0);
    }

    private Optional<MessageType> type(String name, int depth) {
        List<Map<String, Object>> described = fields.get(name);
        if (described == null || depth > DEEPEST) {
            return Optional.empty();
        }
        var known = new ArrayList<Field>();
        described.forEach(field -> field(field, depth).ifPresent(known::add));
        return Optional.of(new MessageType(name, known));
    }

    private Optional<Field> field(Map<String, Object> described, int depth) {
        String name = (String) described.getOrDefault("name", "");
        int number = (int) whole(described, "number");
        boolean repeated = whole(described, "label") == REPEATED;
        Optional<Kind> kind = Arrays.stream(Kind.values())
                .filter(one -> one.number() == whole(described, "type") && one != Kind.ENUM)
                .findFirst();
        if (kind.isEmpty()) {
            return Optional.empty();
        }
        Optional<MessageType> type = kind.get() == Kind.MESSAGE
                ? type(((String) described.getOrDefault("type_name", "")).replaceFirst("^\\.", ""), depth + 1)
                : Optional.empty();
        return kind.get() == Kind.MESSAGE && type.isEmpty()
                ? Optional.empty()
                : Optional.of(new Field(number, name, kind.get(), repeated, type, "", List.of()));
    }

    private static long whole(Map<String, Object> of, String field) {
        return of.get(field) instanceof Long number ? number : 0;
    }

    @SuppressWarnings("unchecked") // as ProtoReader makes them
    private static List<Map<String, Object>> many(Map<String, Object> of, String field) {
        return (List<Map<String, Object>>) of.getOrDefault(field, List.of());
    }
}
