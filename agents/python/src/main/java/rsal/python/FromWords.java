package rsal.python;

import java.lang.reflect.Constructor;
import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.Collection;
import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.Set;
import java.util.TreeMap;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;

/// Values that Python has sent, as what Java wants them to be: the reverse of [ToWords].
final class FromWords {
    private static final double NANOS = 1e9;
    private static final Pattern UPPER = Pattern.compile("(?<=[a-z0-9])[A-Z]");

    private FromWords() {}

    static Duration seconds(@Nullable Object words) {
        return Duration.ofNanos(Math.round(number(words) * NANOS));
    }

    static double number(@Nullable Object words) {
        if (words instanceof Number number) {
            return number.doubleValue();
        }
        throw new IllegalArgumentException("'%s' is not a number.".formatted(words));
    }

    static int integer(@Nullable Object words) {
        double number = number(words);
        if (number != Math.rint(number) || Math.abs(number) > Integer.MAX_VALUE) {
            throw new IllegalArgumentException("'%s' is not a whole number.".formatted(words));
        }
        return (int) number;
    }

    /// A message of people's own, which nobody can change.
    static Map<?, ?> map(@Nullable Object words) {
        if (words instanceof Map<?, ?> map) {
            var all = new LinkedHashMap<Object, @Nullable Object>();
            map.forEach((name, each) -> all.put(name, unchanged(each)));
            return Collections.unmodifiableSequencedMap(all);
        }
        throw new IllegalArgumentException("'%s' is not a dict.".formatted(words));
    }

    static List<?> list(@Nullable Object words) {
        if (words instanceof List<?> list) {
            return list;
        }
        throw new IllegalArgumentException("'%s' is not a list.".formatted(words));
    }

    private static @Nullable Object unchanged(@Nullable Object words) {
        return switch (words) {
            case Map<?, ?> map -> map(map);
            case List<?> list -> {
                var all = new ArrayList<@Nullable Object>();
                list.forEach(each -> all.add(unchanged(each)));
                yield Collections.unmodifiableList(all);
            }
            case null, default -> words;
        };
    }

    /// @throws IllegalArgumentException when it can't be that
    static Object value(@Nullable Object words, Type type) {
        if (type instanceof ParameterizedType several) {
            return container(words, (Class<?>) several.getRawType(), several.getActualTypeArguments());
        }
        Class<?> plain = (Class<?>) type;
        if (plain == OptionalInt.class) {
            return words == null ? OptionalInt.empty() : OptionalInt.of(integer(words));
        }
        if (plain == OptionalDouble.class) {
            return words == null ? OptionalDouble.empty() : OptionalDouble.of(number(words));
        }
        if (words == null) {
            throw new IllegalArgumentException("None is not a '%s'.".formatted(name(plain)));
        }
        if (plain == double.class || plain == Double.class) {
            return number(words);
        }
        if (plain == int.class || plain == Integer.class) {
            return integer(words);
        }
        if (plain == String.class || plain == boolean.class || plain == Boolean.class) {
            return exactly(words, plain);
        }
        if (plain == Duration.class) {
            return seconds(words);
        }
        if (plain == Instant.class) {
            return Instant.EPOCH.plus(seconds(words));
        }
        if (plain == Map.class) {
            return map(words);
        }
        if (plain.isEnum()) {
            return Stream.of(Objects.requireNonNull(plain.getEnumConstants()))
                    .filter(each -> ((Enum<?>) each).name().equals(words))
                    .findFirst()
                    .orElseThrow(() -> misfit(words, plain));
        }
        if (words instanceof Map<?, ?> fields) {
            return plain.isSealed() ? oneOf(fields, plain) : record(fields, plain);
        }
        if (plain.isArray() && words instanceof List<?> items) {
            return array(items, plain);
        }
        throw misfit(words, plain);
    }

    private static Object exactly(Object words, Class<?> type) {
        boolean fits = type == String.class ? words instanceof String : words instanceof Boolean;
        if (!fits) {
            throw misfit(words, type);
        }
        return words;
    }

    private static IllegalArgumentException misfit(Object words, Class<?> type) {
        return new IllegalArgumentException("'%s' is not a '%s'.".formatted(words, name(type)));
    }

    /// As Python calls a field.
    private static String field(String name) {
        return UPPER.matcher(name).replaceAll("_$0").toLowerCase(Locale.ROOT);
    }

    /// As Python calls a type.
    private static String name(Class<?> type) {
        return switch (type.getSimpleName()) {
            case "String" -> "str";
            case "boolean", "Boolean" -> "bool";
            case "double", "Double", "Duration", "Instant" -> "float";
            case "int", "Integer" -> "int";
            case "List", "Set", "Collection" -> "list";
            case "Map", "NavigableMap" -> "dict";
            default -> type.getSimpleName();
        };
    }

    private static Object container(@Nullable Object words, Class<?> type, Type[] inner) {
        if (type == Optional.class) {
            return words == null ? Optional.empty() : Optional.of(value(words, inner[0]));
        }
        if (Collection.class.isAssignableFrom(type) && words instanceof List<?> items) {
            Collection<Object> all = type == Set.class ? new LinkedHashSet<>() : new ArrayList<>();
            items.forEach(item -> all.add(value(item, inner[0])));
            return all instanceof List<Object> list ? Collections.unmodifiableList(list) : all;
        }
        if (Map.class.isAssignableFrom(type) && words instanceof Map<?, ?> entries) {
            Map<String, Object> all = type == NavigableMap.class ? new TreeMap<>() : new LinkedHashMap<>();
            entries.forEach((name, each) -> all.put(String.valueOf(name), value(each, inner[1])));
            return all;
        }
        throw misfit(String.valueOf(words), type);
    }

    private static Object oneOf(Map<?, ?> fields, Class<?> type) {
        return Stream.of(Objects.requireNonNull(type.getPermittedSubclasses()))
                .filter(each -> each.getSimpleName().equals(fields.get("type")))
                .findFirst()
                .map(each -> record(fields, each))
                .orElseThrow(() -> misfit(fields, type));
    }

    /// How a record is made.
    private record Shape(String[] names, Type[] types, Constructor<?> constructor) {
        static Shape of(Class<?> type) {
            RecordComponent[] components = Objects.requireNonNull(type.getRecordComponents(), type.getName());
            try {
                Constructor<?> constructor = type.getDeclaredConstructor(
                        Stream.of(components).map(RecordComponent::getType).toArray(Class<?>[]::new));
                constructor.trySetAccessible(); // of a record that is not public; public ones need nothing
                return new Shape(
                        Stream.of(components).map(RecordComponent::getName).toArray(String[]::new),
                        Stream.of(components)
                                .map(RecordComponent::getGenericType)
                                .toArray(Type[]::new),
                        constructor);
            } catch (NoSuchMethodException e) {
                throw new LinkageError("A record has a constructor for all of it.", e);
            }
        }
    }

    private static final ClassValue<Shape> SHAPES = new ClassValue<>() {
        @Override
        protected Shape computeValue(Class<?> type) {
            return Shape.of(type);
        }
    };

    private static Object record(Map<?, ?> fields, Class<?> type) {
        if (!type.isRecord()) {
            throw misfit(fields, type);
        }
        Shape shape = SHAPES.get(type);
        var values = new Object[shape.names.length];
        for (int i = 0; i < values.length; i++) {
            try {
                values[i] = value(fields.get(shape.names[i]), shape.types[i]);
            } catch (IllegalArgumentException e) {
                throw new IllegalArgumentException(
                        "Field '%s' of '%s': %s".formatted(field(shape.names[i]), type.getSimpleName(), e.getMessage()),
                        e);
            }
        }
        try {
            return shape.constructor.newInstance(values);
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException(
                    "This is not a '%s': %s"
                            .formatted(
                                    type.getSimpleName(),
                                    Objects.requireNonNull(e.getCause()).getMessage()),
                    e);
        } catch (ReflectiveOperationException e) {
            throw new IllegalArgumentException("Python can't make a '%s'.".formatted(type.getSimpleName()), e);
        }
    }

    private static Object array(List<?> items, Class<?> type) {
        if (type == double[].class) {
            return items.stream().mapToDouble(FromWords::number).toArray();
        }
        if (type == int[].class) {
            return items.stream().mapToInt(FromWords::integer).toArray();
        }
        if (type == float[].class) {
            float[] numbers = new float[items.size()];
            for (int i = 0; i < numbers.length; i++) {
                numbers[i] = (float) number(items.get(i));
            }
            return numbers;
        }
        byte[] bytes = new byte[items.size()];
        for (int i = 0; i < bytes.length; i++) {
            bytes[i] = (byte) integer(items.get(i));
        }
        return bytes;
    }
}
