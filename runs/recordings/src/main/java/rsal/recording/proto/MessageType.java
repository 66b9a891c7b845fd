package rsal.recording.proto;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import rsal.mcap.ByteSink;

/// A kind of messages: its fields with their numbers. Immutable.
///
/// @param name with its package: `foxglove.LaserScan`
/// @param fields in the order in which they were declared
public record MessageType(String name, List<Field> fields) {
    private static final String WELL_KNOWN = "google.protobuf.";

    public MessageType {
        fields = List.copyOf(fields);
    }

    /// What a field holds, with the number that descriptors have for it.
    public enum Kind {
        DOUBLE(1),
        INT64(3),
        UINT64(4),
        INT32(5),
        FIXED32(7),
        BOOL(8),
        STRING(9),
        MESSAGE(11),
        BYTES(12),
        ENUM(14);

        private final int number;

        Kind(int number) {
            this.number = number;
        }

        int number() {
            return number;
        }
    }

    /// @param type of a message within
    /// @param enumeration its name; empty for all else
    /// @param words of the enumeration, from 0
    public record Field(
            int number,
            String name,
            Kind kind,
            boolean repeated,
            Optional<MessageType> type,
            String enumeration,
            List<String> words) {
        public Field {
            words = List.copyOf(words);
        }
    }

    public static MessageType named(String name) {
        return new MessageType(name, List.of());
    }

    public MessageType with(int number, String field, Kind kind) {
        return with(new Field(number, field, kind, false, Optional.empty(), "", List.of()));
    }

    public MessageType withMany(int number, String field, Kind kind) {
        return with(new Field(number, field, kind, true, Optional.empty(), "", List.of()));
    }

    public MessageType with(int number, String field, MessageType type) {
        return with(new Field(number, field, Kind.MESSAGE, false, Optional.of(type), "", List.of()));
    }

    public MessageType withMany(int number, String field, MessageType type) {
        return with(new Field(number, field, Kind.MESSAGE, true, Optional.of(type), "", List.of()));
    }

    /// @param words in the order of their numbers, from 0
    public MessageType withEnum(int number, String field, String enumeration, List<String> words) {
        return with(new Field(number, field, Kind.ENUM, false, Optional.empty(), enumeration, words));
    }

    private MessageType with(Field field) {
        var all = new ArrayList<>(fields);
        all.add(field);
        return new MessageType(name, all);
    }

    public Optional<Field> field(int number) {
        return fields.stream().filter(field -> field.number() == number).findFirst();
    }

    /// What describes it and all that it is made of: a `google.protobuf.FileDescriptorSet`, as MCAP wants for the
    /// schema encoding `protobuf`. Each type is a file of its own there, as those of Foxglove are.
    public byte[] descriptors() {
        var all = new LinkedHashMap<String, MessageType>();
        collect(all);
        var out = new ProtoWriter(new ByteSink(1 << 12));
        all.values().forEach(type -> {
            int file = out.begin(1);
            type.describe(out);
            out.end(file);
        });
        return out.sink().toArray();
    }

    /// Those that it is made of first.
    private void collect(Map<String, MessageType> all) {
        fields.stream().flatMap(field -> field.type().stream()).forEach(type -> type.collect(all));
        all.putIfAbsent(name, this);
    }

    private void describe(ProtoWriter out) {
        int dot = name.lastIndexOf('.');
        out.string(1, file());
        out.string(2, name.substring(0, dot));
        fields.stream()
                .flatMap(field -> field.type().stream())
                .map(MessageType::file)
                .distinct()
                .forEach(other -> out.string(3, other));
        int message = out.begin(4);
        out.string(1, name.substring(dot + 1));
        fields.forEach(field -> describe(out, field));
        fields.stream().filter(field -> field.kind() == Kind.ENUM).forEach(field -> {
            int words = out.begin(4);
            out.string(1, field.enumeration());
            for (int i = 0; i < field.words().size(); i++) {
                int word = out.begin(2);
                out.string(1, field.words().get(i));
                out.varint(2, i);
                out.end(word);
            }
            out.end(words);
        });
        out.end(message);
        out.string(12, "proto3");
    }

    private void describe(ProtoWriter out, Field field) {
        int described = out.begin(2);
        out.string(1, field.name());
        out.varint(3, field.number());
        out.varint(4, field.repeated() ? 3 : 1);
        out.varint(5, field.kind().number);
        field.type().ifPresent(type -> out.string(6, "." + type.name()));
        if (field.kind() == Kind.ENUM) {
            out.string(6, "." + name + "." + field.enumeration());
        }
        out.end(described);
    }

    private String file() {
        String path = name.startsWith(WELL_KNOWN) ? name.toLowerCase(Locale.ROOT) : name;
        return path.replace('.', '/') + ".proto";
    }
}
