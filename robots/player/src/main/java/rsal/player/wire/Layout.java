package rsal.player.wire;

import java.lang.invoke.MethodHandle;
import java.lang.invoke.MethodHandles;
import java.lang.invoke.MethodType;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;

/// How a record looks as the body of a message, read off its components, which stand in the order in which they are
/// sent:
///
/// | component | on the wire |
/// |---|---|
/// | `int` | 4 bytes, whatever it is to Player: bool, char, 8, 16 or 32 bits, with or without sign |
/// | `long`, `float`, `double` | 8, 4 and 8 bytes |
/// | a record | its components |
/// | `byte[]` | its length twice, its bytes, filled up to a multiple of 4 |
/// | `float[]`, `double[]`, a `List` of records | its length twice, its elements |
/// | the same with [Times] | its elements |
/// | `int` with [CountOf] | the first of both lengths, where something else stands between them |
///
/// May be used on any thread. Numbers are boxed on their way, but not those in arrays.
public final class Layout<T extends Record> {
    private static final MethodType GETTER = MethodType.methodType(Object.class, Record.class);
    private static final MethodType MAKER = MethodType.methodType(Record.class, Object[].class);

    private static final ClassValue<Layout<?>> KNOWN = new ClassValue<>() {
        @Override
        protected Layout<?> computeValue(Class<?> type) {
            return new Layout<>(type.asSubclass(Record.class));
        }
    };

    private final Class<T> type;
    private final Field[] fields;
    private final MethodHandle constructor;
    private final int least; // bytes

    private record Field(String name, MethodHandle get, Part part) {}

    private Layout(Class<T> type) {
        this.type = type;
        RecordComponent[] components = type.getRecordComponents();
        var counted = new HashSet<String>();
        this.fields = new Field[components.length];
        int sum = 0;
        try {
            var lookup = MethodHandles.lookup();
            for (int i = 0; i < components.length; i++) {
                CountOf countOf = components[i].getAnnotation(CountOf.class);
                if (countOf != null) {
                    counted.add(countOf.value());
                }
                Part part = part(components[i], counted.contains(components[i].getName()));
                fields[i] = new Field(
                        components[i].getName(),
                        lookup.unreflect(components[i].getAccessor()).asType(GETTER),
                        part);
                sum += part.least();
            }
            Class<?>[] types =
                    Arrays.stream(components).map(RecordComponent::getType).toArray(Class<?>[]::new);
            this.constructor = lookup.unreflectConstructor(type.getDeclaredConstructor(types))
                    .asSpreader(Object[].class, components.length)
                    .asType(MAKER);
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException("Record '%s' can't be sent.".formatted(type), e);
        }
        this.least = sum;
    }

    @SuppressWarnings("unchecked") // KNOWN has for each type its own
    public static <T extends Record> Layout<T> of(Class<T> type) {
        return (Layout<T>) KNOWN.get(type);
    }

    @SuppressWarnings("unchecked") // the class of an object is that
    static <T extends Record> Layout<T> of(T value) {
        return (Layout<T>) KNOWN.get(value.getClass());
    }

    private static Part part(RecordComponent component, boolean counted) {
        Class<?> type = component.getType();
        Times times = component.getAnnotation(Times.class);
        if (times != null) {
            return new Part.Fixed(times.value(), elements(component));
        }
        if (type == int.class) {
            return Part.INT;
        }
        if (type == long.class) {
            return Part.LONG;
        }
        if (type == float.class) {
            return Part.FLOAT;
        }
        if (type == double.class) {
            return Part.DOUBLE;
        }
        if (type.isRecord()) {
            return new Part.Nested(of(type.asSubclass(Record.class)));
        }
        return new Part.Counted(counted, elements(component));
    }

    private static Part.Elements elements(RecordComponent component) {
        Class<?> type = component.getType();
        if (type == byte[].class) {
            return Part.BYTES;
        }
        if (type == float[].class) {
            return Part.FLOATS;
        }
        if (type == double[].class) {
            return Part.DOUBLES;
        }
        if (type == List.class && component.getGenericType() instanceof ParameterizedType list) {
            Class<?> element = (Class<?>) list.getActualTypeArguments()[0];
            return new Part.Records(of(element.asSubclass(Record.class)));
        }
        throw new IllegalArgumentException("Component '%s' can't be sent.".formatted(component));
    }

    /// What a body says.
    ///
    /// @throws MalformedException when it is not of that layout, or there is more of it
    public T read(byte[] body) throws MalformedException {
        var from = ByteBuffer.wrap(body);
        T value = read(from);
        if (from.hasRemaining()) {
            throw new MalformedException("A body of %d bytes is too long: %s has %d."
                    .formatted(body.length, type.getSimpleName(), body.length - from.remaining()));
        }
        return value;
    }

    /// What a body begins with; whatever stands behind that is left.
    ///
    /// @throws MalformedException when it is not of that layout
    public T readStart(byte[] body) throws MalformedException {
        return read(ByteBuffer.wrap(body));
    }

    T read(ByteBuffer from) throws MalformedException {
        var values = new Object[fields.length];
        for (int i = 0; i < fields.length; i++) {
            Field field = fields[i];
            if (from.remaining() < field.part.least()) {
                throw new MalformedException("%s ends before its %s.".formatted(type.getSimpleName(), field.name));
            }
            values[i] = field.part.read(from);
        }
        try {
            return type.cast((Record) constructor.invokeExact(values));
        } catch (Throwable e) {
            throw new MalformedException(
                    "%s can't have such values: %s".formatted(type.getSimpleName(), e.getMessage()));
        }
    }

    public byte[] bytes(T value) {
        var to = ByteBuffer.allocate(size(value));
        write(value, to);
        return to.array();
    }

    /// Bytes that the shortest one has.
    int least() {
        return least;
    }

    int size(Record value) {
        int sum = 0;
        for (Field field : fields) {
            sum += field.part.size(get(field, value));
        }
        return sum;
    }

    void write(Record value, ByteBuffer to) {
        for (Field field : fields) {
            field.part.write(get(field, value), to);
        }
    }

    private static Object get(Field field, Record value) {
        try {
            return (Object) field.get.invokeExact(value);
        } catch (Throwable e) {
            throw new IllegalStateException("Component '%s' can't be read.".formatted(field.name), e);
        }
    }
}
