package rsal.environment;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.time.Duration;
import java.util.Collection;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import java.util.regex.Pattern;
import org.jspecify.annotations.Nullable;
import rsal.agent.Topic;
import rsal.settings.Suggestion;

/// A number in messages of a topic, by names as Python writes them: `map_from_base.x`. Numbers are as they are, flags
/// are 0 or 1, durations are in seconds, and what a message leaves out (an empty [Optional]) is 0. Immutable.
///
/// @param topic its name, for errors
/// @param path names of components of records, or keys of maps, from outside to inside
record MessageNumber(String topic, List<String> path) {
    private static final Pattern UPPER = Pattern.compile("(?<=[a-z0-9])[A-Z]");
    private static final double NANOS = 1e9;
    private static final ClassValue<Map<String, Method>> COMPONENTS = new ClassValue<>() {
        @Override
        protected Map<String, Method> computeValue(Class<?> type) {
            var byName = new LinkedHashMap<String, Method>();
            for (RecordComponent component : Objects.requireNonNull(type.getRecordComponents(), type.getName())) {
                byName.put(inPython(component.getName()), component.getAccessor());
            }
            return byName;
        }
    };

    /// Finds the number before there are messages, as far as the topic's type says what they have: those of maps
    /// are known only when there is one.
    ///
    /// @throws IllegalArgumentException in a sentence for people, when they have no such number
    static MessageNumber of(Topic<?> topic, String name) {
        var number = new MessageNumber(topic.name(), List.of(name.split("\\.", -1)));
        Type type = topic.type();
        for (String each : number.path) {
            Class<?> inside = inside(type);
            if (Map.class.isAssignableFrom(inside)) {
                return number;
            }
            if (!inside.isRecord()) {
                throw number.lacks(each, List.of());
            }
            Method accessor = COMPONENTS.get(inside).get(each);
            if (accessor == null) {
                throw number.lacks(each, COMPONENTS.get(inside).keySet());
            }
            type = accessor.getGenericReturnType();
        }
        if (!isNumber(inside(type))) {
            Class<?> last = inside(type);
            throw number.lacks(
                    number.name(), last.isRecord() ? COMPONENTS.get(last).keySet() : List.of());
        }
        return number;
    }

    String name() {
        return String.join(".", path);
    }

    /// @throws IllegalArgumentException in a sentence for people, when this message has no such number
    double in(Object content) {
        Object value = content;
        for (String each : path) {
            value = present(value);
            switch (value) {
                case null -> {
                    return 0;
                }
                case Map<?, ?> map -> {
                    if (!map.containsKey(each)) {
                        throw lacks(
                                each, map.keySet().stream().map(String::valueOf).toList());
                    }
                    value = map.get(each);
                }
                case Record made -> value = component(made, each);
                default -> throw lacks(each, List.of());
            }
        }
        return switch (present(value)) {
            case null -> 0;
            case Number number -> number.doubleValue();
            case Boolean flag -> flag ? 1 : 0;
            case Duration time -> time.getSeconds() + time.getNano() / NANOS;
            default -> throw lacks(name(), List.of());
        };
    }

    private @Nullable Object component(Record made, String name) {
        Method accessor = COMPONENTS.get(made.getClass()).get(name);
        if (accessor == null) {
            throw lacks(name, COMPONENTS.get(made.getClass()).keySet());
        }
        try {
            return accessor.invoke(made);
        } catch (IllegalAccessException | InvocationTargetException e) {
            throw new IllegalArgumentException("'%s' of '%s' can't be read.".formatted(name, made), e);
        }
    }

    private static @Nullable Object present(@Nullable Object value) {
        return switch (value) {
            case Optional<?> maybe -> maybe.orElse(null);
            case OptionalDouble maybe -> maybe.isPresent() ? (Object) maybe.getAsDouble() : null;
            case OptionalInt maybe -> maybe.isPresent() ? (Object) maybe.getAsInt() : null;
            case null, default -> value;
        };
    }

    private static Class<?> inside(Type type) {
        return switch (type) {
            case Class<?> known -> known;
            case ParameterizedType many
            when many.getRawType() == Optional.class -> inside(many.getActualTypeArguments()[0]);
            case ParameterizedType many -> inside(many.getRawType());
            default -> Object.class;
        };
    }

    private static boolean isNumber(Class<?> type) {
        return Number.class.isAssignableFrom(type)
                || type == Boolean.class
                || (type.isPrimitive() && type != char.class)
                || type == Duration.class
                || type == OptionalDouble.class
                || type == OptionalInt.class;
    }

    private IllegalArgumentException lacks(String name, Collection<String> known) {
        String what = "Messages of the topic '%s' have no number '%s'".formatted(topic, name());
        String where = name.equals(name()) ? "." : ": there is no '%s'.".formatted(name);
        return new IllegalArgumentException(
                what + where + (known.isEmpty() ? "" : " " + Suggestion.among(name, known)));
    }

    private static String inPython(String name) {
        return UPPER.matcher(name).replaceAll("_$0").toLowerCase(Locale.ROOT);
    }
}
