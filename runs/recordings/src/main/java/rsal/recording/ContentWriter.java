package rsal.recording;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collection;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.OptionalLong;
import java.util.Set;
import org.jspecify.annotations.Nullable;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Kind;
import rsal.recording.proto.ProtoWriter;

/// Writes what agents say, records of any class, with a field for each component by its own name: numbers as
/// `double`, whole numbers as `int64`, flags as `bool`, records as messages within, lists as repeated fields,
/// maps as pairs, times and durations in s. All else is words. What an [Optional] does not hold is left out.
/// For one thread.
final class ContentWriter {
    /// Prefix of the names of these kinds of messages.
    static final String PACKAGE = "rsal.message.";

    private static final int DEEPEST = 4; // records within records
    private static final int MOST_KINDS = 300;
    private static final int MOST_ELEMENTS = 10_000; // of a list
    private static final int TIMESTAMP = 1;
    private static final int FROM = 2;
    private static final int TO = 3;
    private static final int CONVERSATION = 4;
    private static final int CONTENT = 5;

    private final Map<Class<?>, Optional<Content>> kinds = new HashMap<>();
    private final Set<String> names = new HashSet<>();

    /// How a value is written.
    private sealed interface Way {}

    private enum Plain implements Way {
        NUMBER(Kind.DOUBLE),
        WHOLE(Kind.INT64),
        FLAG(Kind.BOOL),
        WORDS(Kind.STRING);

        private final Kind kind;

        Plain(Kind kind) {
            this.kind = kind;
        }
    }

    private record Pairs() implements Way {}

    private record Many(Way each) implements Way {}

    private record Within(MessageType type, List<Part> parts) implements Way {}

    private record Part(int number, RecordComponent component, Way way) {}

    /// A kind of message: its type has who says it to whom around the content.
    static final class Content {
        private final MessageType type;
        private final Within within;

        private Content(MessageType type, Within within) {
            this.type = type;
            this.within = within;
        }

        MessageType type() {
            return type;
        }

        /// Without its package.
        String name() {
            return type.name().substring(PACKAGE.length());
        }
    }

    /// How messages of a class are written; empty for what has no fields, and for too many kinds.
    Optional<Content> of(Class<?> said) {
        Optional<Content> known = kinds.get(said);
        if (known == null) {
            known = said.isRecord() && kinds.size() < MOST_KINDS ? Optional.of(content(said)) : Optional.empty();
            kinds.put(said, known);
        }
        return known;
    }

    private Content content(Class<?> said) {
        var name = new StringBuilder(identifier(said.getSimpleName()));
        while (!names.add(name.toString())) {
            name.append('_'); // another class is called so, too
        }
        Within within = within(name.toString(), said, new ArrayList<>());
        MessageType type = MessageType.named(PACKAGE + name)
                .with(TIMESTAMP, "timestamp", Foxglove.TIMESTAMP)
                .with(FROM, "from", Kind.STRING)
                .with(TO, "to", Kind.STRING)
                .with(CONVERSATION, "conversation", Kind.STRING)
                .with(CONTENT, "content", within.type());
        return new Content(type, within);
    }

    /// As protobuf can have it.
    private static String identifier(String name) {
        return name.replaceAll("[^A-Za-z0-9_]", "_");
    }

    /// @param outer the classes that it is within
    private static Within within(String path, Class<?> of, List<Class<?>> outer) {
        List<Class<?>> inner = new ArrayList<>(outer);
        inner.add(of);
        MessageType type = MessageType.named(PACKAGE + "content." + path);
        var parts = new ArrayList<Part>();
        for (RecordComponent component : of.getRecordComponents()) {
            int number = parts.size() + 1;
            Way way = way(component.getGenericType(), path + "_" + identifier(component.getName()), inner);
            type = with(type, number, identifier(component.getName()), way);
            parts.add(new Part(number, component, way));
        }
        return new Within(type, parts);
    }

    private static MessageType with(MessageType type, int number, String name, Way way) {
        return switch (way) {
            case Plain plain -> type.with(number, name, plain.kind);
            case Pairs _ -> type.withMany(number, name, Foxglove.KEY_VALUE);
            case Within within -> type.with(number, name, within.type());
            case Many(Plain plain) -> type.withMany(number, name, plain.kind);
            case Many(Within within) -> type.withMany(number, name, within.type());
            case Many _ -> type.withMany(number, name, Kind.STRING);
        };
    }

    private static Way way(Type declared, String path, List<Class<?>> outer) {
        if (declared instanceof ParameterizedType generic && generic.getRawType() instanceof Class<?> raw) {
            Type first = generic.getActualTypeArguments()[0];
            if (raw == Optional.class) {
                return way(first, path, outer);
            }
            if (Collection.class.isAssignableFrom(raw)) {
                return many(first, path, outer);
            }
            return Map.class.isAssignableFrom(raw) ? new Pairs() : Plain.WORDS;
        }
        if (!(declared instanceof Class<?> type)) {
            return Plain.WORDS;
        }
        if (type.isArray()) {
            return many(type.getComponentType(), path, outer);
        }
        if (type == boolean.class || type == Boolean.class) {
            return Plain.FLAG;
        }
        if (Set.of(int.class, long.class, short.class, byte.class).contains(type)
                || Set.of(Integer.class, Long.class, Short.class, Byte.class).contains(type)) {
            return Plain.WHOLE;
        }
        if (isNumber(type)) {
            return Plain.NUMBER;
        }
        boolean isWithin = type.isRecord() && outer.size() < DEEPEST && !outer.contains(type);
        return isWithin ? within(path, type, outer) : Plain.WORDS;
    }

    private static boolean isNumber(Class<?> type) {
        return type == double.class
                || type == float.class
                || Number.class.isAssignableFrom(type)
                || Set.of(OptionalDouble.class, OptionalInt.class, OptionalLong.class, Duration.class, Instant.class)
                        .contains(type);
    }

    private static Way many(Type each, String path, List<Class<?>> outer) {
        Way way = way(each, path, outer);
        return switch (way) {
            case Plain plain when plain == Plain.WHOLE || plain == Plain.NUMBER -> new Many(Plain.NUMBER);
            case Within within -> new Many(within);
            default -> new Many(Plain.WORDS);
        };
    }

    // ── Writing ──────────────────────────────────────────────────────────────────────────────────────────────────

    /// @param content of the class of which the kind was asked for
    /// @throws IllegalArgumentException when it can't be read
    static void write(ProtoWriter out, Content kind, String from, String to, String conversation, Object content) {
        out.string(FROM, from);
        out.string(TO, to);
        out.string(CONVERSATION, conversation);
        write(out, CONTENT, kind.within, content);
    }

    private static void write(ProtoWriter out, int number, Way way, @Nullable Object declared) {
        Object value = declared instanceof Optional<?> some ? some.orElse(null) : declared;
        if (value == null) {
            return;
        }
        switch (way) {
            case Plain.NUMBER -> out.number(number, number(value));
            case Plain.WHOLE -> out.varint(number, ((Number) value).longValue());
            case Plain.FLAG -> out.bool(number, (Boolean) value);
            case Plain.WORDS -> out.string(number, words(value));
            case Pairs _ -> pairs(out, number, value);
            case Within within -> {
                int begun = out.begin(number);
                within.parts.forEach(part -> write(out, part.number, part.way, read(part.component, value)));
                out.end(begun);
            }
            case Many many -> many(out, number, many.each, elements(value));
        }
    }

    private static void many(ProtoWriter out, int number, Way each, List<?> elements) {
        if (each == Plain.NUMBER) {
            out.numbers(
                    number, elements.stream().mapToDouble(ContentWriter::number).toArray());
            return;
        }
        for (Object element : elements) {
            if (each instanceof Within) {
                write(out, number, each, element);
            } else {
                int begun = out.begin(number); // also for an empty text
                out.sink().characters(words(element));
                out.end(begun);
            }
        }
    }

    private static void pairs(ProtoWriter out, int number, Object value) {
        if (value instanceof Map<?, ?> map) {
            map.entrySet().stream().limit(MOST_ELEMENTS).forEach(entry -> {
                int begun = out.begin(number);
                out.string(1, words(entry.getKey()));
                out.string(2, words(entry.getValue()));
                out.end(begun);
            });
        }
    }

    private static List<?> elements(Object value) {
        return switch (value) {
            case Collection<?> all -> all.stream().limit(MOST_ELEMENTS).toList();
            case double[] all -> Arrays.stream(all).limit(MOST_ELEMENTS).boxed().toList();
            case int[] all -> Arrays.stream(all).limit(MOST_ELEMENTS).boxed().toList();
            case long[] all -> Arrays.stream(all).limit(MOST_ELEMENTS).boxed().toList();
            case Object[] all -> Arrays.stream(all).limit(MOST_ELEMENTS).toList();
            case float[] all -> {
                var boxed = new ArrayList<Float>();
                for (int i = 0; i < Math.min(all.length, MOST_ELEMENTS); i++) {
                    boxed.add(all[i]);
                }
                yield boxed;
            }
            default -> List.of();
        };
    }

    private static double number(@Nullable Object value) {
        return switch (value) {
            case Number number -> number.doubleValue();
            case OptionalDouble number -> number.orElse(Double.NaN);
            case OptionalInt number -> number.isPresent() ? number.getAsInt() : Double.NaN;
            case OptionalLong number -> number.isPresent() ? (double) number.getAsLong() : Double.NaN;
            case Duration duration -> duration.toNanos() / 1e9;
            case Instant instant -> instant.getEpochSecond() + instant.getNano() / 1e9;
            case null, default -> Double.NaN;
        };
    }

    /// Of objects that do not say what they are in words of their own, nothing: their words differ from run to
    /// run.
    private static String words(@Nullable Object value) {
        return switch (value) {
            case null -> "";
            case String text -> text;
            case Enum<?> constant -> constant.toString();
            case Number _, Boolean _, Character _, Record _, Collection<?> _, Map<?, ?> _, Duration _, Instant _ ->
                value.toString();
            default -> "";
        };
    }

    private static @Nullable Object read(RecordComponent component, Object record) {
        try {
            component.getAccessor().trySetAccessible();
            return component.getAccessor().invoke(record);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalArgumentException("'%s' can't be read.".formatted(component), e);
        }
    }
}
