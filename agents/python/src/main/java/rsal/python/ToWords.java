package rsal.python;

import java.io.ByteArrayOutputStream;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.RecordComponent;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.Collection;
import java.util.Comparator;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.SequencedMap;
import java.util.SequencedSet;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import tools.jackson.core.JsonGenerator;

/// Values as Python gets them: records by the names of their components, of several possible ones with their `type`;
/// enumerations by their names, times and durations in seconds, arrays apart from the words.
final class ToWords {
    private static final double NANOS = 1e9;

    private static final ClassValue<Shape> SHAPES = new ClassValue<>() {
        @Override
        protected Shape computeValue(Class<?> type) {
            return Shape.of(type);
        }
    };

    private final JsonGenerator words;
    private final ByteArrayOutputStream arrays;

    ToWords(JsonGenerator words, ByteArrayOutputStream arrays) {
        this.words = words;
        this.arrays = arrays;
    }

    /// The components of a record.
    ///
    /// @param type to tell it from others in its place; empty when there are none
    private record Shape(Optional<String> type, String[] names, Method[] accessors) {
        static Shape of(Class<?> type) {
            RecordComponent[] components = Objects.requireNonNull(type.getRecordComponents(), type.getName());
            boolean oneOfSeveral = Stream.of(type.getInterfaces()).anyMatch(Class::isSealed);
            return new Shape(
                    oneOfSeveral ? Optional.of(type.getSimpleName()) : Optional.empty(),
                    Arrays.stream(components).map(RecordComponent::getName).toArray(String[]::new),
                    Arrays.stream(components).map(Shape::accessor).toArray(Method[]::new));
        }

        private static Method accessor(RecordComponent component) {
            Method accessor = component.getAccessor();
            accessor.trySetAccessible(); // of a record that is not public; public ones need nothing
            return accessor;
        }
    }

    static double seconds(Instant time) {
        return time.getEpochSecond() + time.getNano() / NANOS;
    }

    static double seconds(Duration duration) {
        return duration.getSeconds() + duration.getNano() / NANOS;
    }

    ToWords put(String name, @Nullable Object value) {
        words.writeName(name);
        write(value);
        return this;
    }

    ToWords put(String name, int value) {
        words.writeName(name);
        words.writeNumber(value);
        return this;
    }

    /// An object in the words.
    ToWords begin(String name) {
        words.writeName(name);
        words.writeStartObject();
        return this;
    }

    ToWords end() {
        words.writeEndObject();
        return this;
    }

    private void write(@Nullable Object value) {
        switch (value) {
            case null -> words.writeNull();
            case String text -> words.writeString(text);
            case Boolean flag -> words.writeBoolean(flag);
            case Double number -> words.writeNumber(number);
            case Integer number -> words.writeNumber(number);
            case Long number -> words.writeNumber(number);
            case Byte number -> words.writeNumber(number);
            case Float number -> words.writeNumber(number);
            case Enum<?> word -> words.writeString(word.name());
            case Optional<?> maybe -> write(maybe.orElse(null));
            case OptionalInt maybe -> write(maybe.isPresent() ? (Object) maybe.getAsInt() : null);
            case OptionalDouble maybe -> write(maybe.isPresent() ? (Object) maybe.getAsDouble() : null);
            case Instant time -> words.writeNumber(seconds(time));
            case Duration duration -> words.writeNumber(seconds(duration));
            case Collection<?> all -> {
                words.writeStartArray();
                inOrder(all).forEach(this::write);
                words.writeEndArray();
            }
            case Map<?, ?> map -> {
                words.writeStartObject();
                inOrder(map).forEach((name, each) -> put(String.valueOf(name), each));
                words.writeEndObject();
            }
            case float[] numbers -> {
                array("f4", numbers.length);
                var bytes = ByteBuffer.allocate(Float.BYTES * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
                bytes.asFloatBuffer().put(numbers);
                arrays.writeBytes(bytes.array());
            }
            case double[] numbers -> {
                array("f8", numbers.length);
                var bytes = ByteBuffer.allocate(Double.BYTES * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
                bytes.asDoubleBuffer().put(numbers);
                arrays.writeBytes(bytes.array());
            }
            case int[] numbers -> {
                array("i4", numbers.length);
                var bytes = ByteBuffer.allocate(Integer.BYTES * numbers.length).order(ByteOrder.LITTLE_ENDIAN);
                bytes.asIntBuffer().put(numbers);
                arrays.writeBytes(bytes.array());
            }
            case byte[] numbers -> {
                array("i1", numbers.length);
                arrays.writeBytes(numbers);
            }
            case Record made -> fields(made);
            default -> words.writeString(value.toString());
        }
    }

    /// By name, where a map has no order of its own: that of [Map#of] is another one in each process.
    private static Map<?, ?> inOrder(Map<?, ?> map) {
        if (map instanceof SequencedMap) {
            return map;
        }
        var sorted = new TreeMap<String, @Nullable Object>();
        map.forEach((name, each) -> sorted.put(String.valueOf(name), each));
        return sorted;
    }

    private static Collection<?> inOrder(Collection<?> all) {
        return all instanceof Set && !(all instanceof SequencedSet)
                ? all.stream().sorted(Comparator.comparing(String::valueOf)).toList()
                : all;
    }

    private void array(String type, int count) {
        words.writeStartObject();
        put("array", type).put("at", arrays.size()).put("count", count);
        words.writeEndObject();
    }

    private void fields(Record made) {
        Shape shape = SHAPES.get(made.getClass());
        words.writeStartObject();
        shape.type.ifPresent(type -> put("type", type));
        for (int i = 0; i < shape.names.length; i++) {
            put(shape.names[i], component(shape.accessors[i], made));
        }
        words.writeEndObject();
    }

    private static @Nullable Object component(Method accessor, Record made) {
        try {
            return accessor.invoke(made);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalArgumentException("'%s' can't be sent to Python.".formatted(made), e);
        }
    }
}
