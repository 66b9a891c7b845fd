package rsal.recording;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import rsal.data.Pose2d;
import rsal.recording.proto.MessageType;
import rsal.recording.proto.MessageType.Kind;
import rsal.recording.proto.ProtoWriter;

/// Writes and reads records of a class by their components, each a field of its name in lower case
/// (`accelerationX`: `acceleration_x`). So a new kind of devices says nowhere else how its readings
/// are recorded.
///
/// Components are numbers, flags, texts, words of an enumeration, poses, arrays of numbers or bytes, records of
/// these and lists of records.
final class RecordCodec<T> {
    private final List<Field> fields;
    private final Constructor<T> constructor;
    private final MessageType message;

    private record Field(RecordComponent component, int number, String name, Type type) {}

    /// How a component is declared, written and read.
    private record Type(Declaration declaration, Writer writer, Reader reader) {}

    private interface Declaration {
        MessageType with(MessageType message, int number, String name);
    }

    private interface Writer {
        void write(ProtoWriter out, int field, Object value);
    }

    private interface Reader {
        Object read(MessageFields fields, String name);
    }

    private RecordCodec(List<Field> fields, Constructor<T> constructor, MessageType message) {
        this.fields = fields;
        this.constructor = constructor;
        this.message = message;
    }

    /// @param empty message to which fields are added
    /// @param first number of the first field
    /// @throws IllegalArgumentException when there is a component of which nobody knows how to write it
    static <T> RecordCodec<T> of(Class<T> reported, MessageType empty, int first) {
        var fields = new ArrayList<Field>();
        var types = new ArrayList<Class<?>>();
        MessageType message = empty;
        for (RecordComponent component : reported.getRecordComponents()) {
            int number = first + fields.size();
            String name = component
                    .getName()
                    .replaceAll("(?<=[a-z0-9])(?=[A-Z])", "_")
                    .toLowerCase(Locale.ROOT);
            Type type = type(component);
            fields.add(new Field(component, number, name, type));
            types.add(component.getType());
            message = type.declaration.with(message, number, name);
        }
        try {
            return new RecordCodec<>(
                    List.copyOf(fields), reported.getDeclaredConstructor(types.toArray(Class<?>[]::new)), message);
        } catch (NoSuchMethodException e) {
            throw new IllegalArgumentException(e);
        }
    }

    MessageType message() {
        return message;
    }

    void write(ProtoWriter out, Object value) {
        for (Field field : fields) {
            field.type.writer.write(out, field.number, component(field.component, value));
        }
    }

    private static Object component(RecordComponent component, Object value) {
        try {
            return component.getAccessor().invoke(value);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalStateException(e);
        }
    }

    /// @throws IllegalArgumentException when there is no such record
    T read(MessageFields values) {
        Object[] arguments = new Object[fields.size()];
        for (int i = 0; i < arguments.length; i++) {
            arguments[i] = fields.get(i).type.reader.read(values, fields.get(i).name);
        }
        try {
            return constructor.newInstance(arguments);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException(e.getCause());
        } catch (InstantiationException | IllegalAccessException e) {
            throw new IllegalStateException(e);
        }
    }

    private static Type type(RecordComponent component) {
        Class<?> type = component.getType();
        if (type == double.class) {
            return simple(Kind.DOUBLE, (out, field, value) -> out.number(field, (Double) value), MessageFields::number);
        }
        if (type == float.class) {
            return simple(Kind.DOUBLE, (out, field, value) -> out.number(field, (Float) value), (fields, name) ->
                    (float) fields.number(name));
        }
        if (type == int.class) {
            return simple(
                    Kind.INT64,
                    (out, field, value) -> out.varint(field, (Integer) value),
                    (fields, name) -> Math.toIntExact(fields.count(name)));
        }
        if (type == long.class) {
            return simple(Kind.INT64, (out, field, value) -> out.varint(field, (Long) value), MessageFields::count);
        }
        if (type == boolean.class) {
            return simple(Kind.BOOL, (out, field, value) -> out.bool(field, (Boolean) value), MessageFields::flag);
        }
        if (type == String.class) {
            return simple(Kind.STRING, (out, field, value) -> out.string(field, (String) value), MessageFields::text);
        }
        if (type == byte[].class) {
            return simple(Kind.BYTES, (out, field, value) -> out.bytes(field, (byte[]) value), MessageFields::bytes);
        }
        if (type == float[].class) {
            return many((out, field, value) -> out.numbers(field, (float[]) value), MessageFields::floats);
        }
        if (type == double[].class) {
            return many((out, field, value) -> out.numbers(field, (double[]) value), MessageFields::doubles);
        }
        if (type.isEnum()) {
            return simple(
                    Kind.STRING,
                    (out, field, value) -> out.string(field, ((Enum<?>) value).name()),
                    (fields, name) -> word(type, fields.text(name)));
        }
        if (type == Pose2d.class) {
            return within(
                    Own.POSE,
                    (out, field, value) -> Own.pose(out, field, (Pose2d) value),
                    (fields, name) -> fields.pose(name).orElse(Pose2d.ORIGIN));
        }
        if (type.isRecord()) {
            return one(of(type, MessageType.named(type.getName()), 1));
        }
        if (type == List.class
                && component.getGenericType() instanceof ParameterizedType list
                && list.getActualTypeArguments()[0] instanceof Class<?> element
                && element.isRecord()) {
            return several(of(element, MessageType.named(element.getName()), 1));
        }
        throw new IllegalArgumentException("Readings can't have a component '%s' of type '%s'."
                .formatted(component.getName(), component.getGenericType().getTypeName()));
    }

    private static Object word(Class<?> type, String text) {
        for (Object word : type.getEnumConstants()) {
            if (((Enum<?>) word).name().equals(text)) {
                return word;
            }
        }
        throw new IllegalArgumentException("There is no '%s' among '%s'.".formatted(text, type.getSimpleName()));
    }

    private static Type simple(Kind kind, Writer writer, Reader reader) {
        return new Type((message, number, name) -> message.with(number, name, kind), writer, reader);
    }

    private static Type many(Writer writer, Reader reader) {
        return new Type((message, number, name) -> message.withMany(number, name, Kind.DOUBLE), writer, reader);
    }

    private static Type within(MessageType type, Writer writer, Reader reader) {
        return new Type((message, number, name) -> message.with(number, name, type), writer, reader);
    }

    private static Type one(RecordCodec<?> codec) {
        return within(
                codec.message,
                codec::within,
                (fields, name) -> codec.read(fields.within(name)
                        .orElseThrow(() -> new IllegalArgumentException("There is no '%s'.".formatted(name)))));
    }

    private static Type several(RecordCodec<?> codec) {
        return new Type(
                (message, number, name) -> message.withMany(number, name, codec.message),
                (out, field, value) -> ((List<?>) value).forEach(each -> codec.within(out, field, each)),
                (fields, name) -> fields.all(name).stream().map(codec::read).toList());
    }

    private void within(ProtoWriter out, int field, Object value) {
        int begun = out.begin(field);
        write(out, value);
        out.end(begun);
    }
}
