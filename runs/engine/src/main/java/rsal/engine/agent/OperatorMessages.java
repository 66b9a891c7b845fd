package rsal.engine.agent;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.ParameterizedType;
import java.lang.reflect.RecordComponent;
import java.lang.reflect.Type;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.jspecify.annotations.Nullable;
import rsal.agent.Topic;
import rsal.agent.Topics;
import rsal.data.Point2d;
import rsal.data.Pose2d;
import rsal.engine.report.OperatorMessage;
import rsal.engine.report.OperatorMessage.Field;
import rsal.engine.report.OperatorMessage.Kind;

/// Which messages people can say, and how what they type becomes one. Knows no message by name: all common topics count
/// whose records have only fields that can be typed.
public final class OperatorMessages {
    /// In the order of [Topics#installed].
    public static final List<OperatorMessage> ALL = Topics.installed().stream()
            .flatMap(topic -> sayable(topic).stream())
            .toList();

    private static final Pattern BETWEEN_NUMBERS = Pattern.compile("[\\s,]+");
    private static final Pattern BETWEEN_PLACES = Pattern.compile(";");

    private OperatorMessages() {}

    /// Something to be said.
    record Phrase<M>(Topic<M> topic, M message) {}

    private static Optional<OperatorMessage> sayable(Topic<?> topic) {
        List<Optional<Field>> fields =
                components(topic.type()).map(OperatorMessages::field).toList();
        return fields.stream().allMatch(Optional::isPresent)
                ? Optional.of(new OperatorMessage(
                        topic.name(), fields.stream().flatMap(Optional::stream).toList()))
                : Optional.empty();
    }

    private static Stream<RecordComponent> components(Class<?> type) {
        return Arrays.stream(Objects.requireNonNull(type.getRecordComponents(), "all messages are records"));
    }

    private static Optional<Field> field(RecordComponent component) {
        return kind(component.getGenericType())
                .map(kind -> new Field(component.getName(), kind, choices(component.getType())));
    }

    private static Optional<Kind> kind(Type type) {
        if (type instanceof ParameterizedType many) {
            boolean places = many.getRawType() == List.class && many.getActualTypeArguments()[0] == Point2d.class;
            return places ? Optional.of(Kind.PLACES) : Optional.empty();
        }
        if (type == String.class) {
            return Optional.of(Kind.WORDS);
        }
        if (type == double.class || type == int.class) {
            return Optional.of(Kind.NUMBER);
        }
        if (type == Point2d.class) {
            return Optional.of(Kind.PLACE);
        }
        if (type == Pose2d.class) {
            return Optional.of(Kind.POSE);
        }
        return type instanceof Class<?> plain && !choices(plain).isEmpty()
                ? Optional.of(Kind.CHOICE)
                : Optional.empty();
    }

    private static List<String> choices(Class<?> type) {
        if (type == boolean.class) {
            return List.of("true", "false");
        }
        return type.isEnum()
                ? Arrays.stream(type.getEnumConstants()).map(Object::toString).toList()
                : List.of();
    }

    /// @param topic name of one in [#ALL]
    /// @param typed what was typed, by name of the field
    /// @throws IllegalArgumentException with a sentence when that is no message
    static Phrase<?> read(String topic, Map<String, String> typed) {
        return Topics.installed().stream()
                .filter(one -> one.name().equals(topic))
                .filter(one -> ALL.stream().anyMatch(known -> known.topic().equals(topic)))
                .findFirst()
                .map(one -> phrase(one, typed))
                .orElseThrow(() -> new IllegalArgumentException("People can't send messages on topic '%s', only on %s."
                        .formatted(
                                topic, ALL.stream().map(OperatorMessage::topic).toList())));
    }

    private static <M> Phrase<M> phrase(Topic<M> topic, Map<String, String> typed) {
        Class<M> type = topic.type();
        List<String> words = components(type)
                .filter(field -> field.getType() == String.class)
                .map(RecordComponent::getName)
                .toList();
        if (!words.isEmpty() && words.stream().allMatch(name -> isEmpty(typed.get(name)))) {
            throw new IllegalArgumentException("Field '%s' takes words, and is empty.".formatted(words.getFirst()));
        }
        Class<?>[] types = components(type).map(RecordComponent::getType).toArray(Class<?>[]::new);
        Object[] values = components(type)
                .map(field -> value(
                        field,
                        Objects.requireNonNullElse(typed.get(field.getName()), "")
                                .strip()))
                .toArray();
        try {
            return new Phrase<>(topic, type.getDeclaredConstructor(types).newInstance(values));
        } catch (InvocationTargetException e) {
            throw new IllegalArgumentException(
                    "This is not a '%s': %s"
                            .formatted(
                                    topic.name(),
                                    Objects.requireNonNull(e.getCause()).getMessage()),
                    e);
        } catch (ReflectiveOperationException e) {
            throw new LinkageError("A message's record has a constructor for all of it.", e);
        }
    }

    private static boolean isEmpty(@Nullable String typed) {
        return typed == null || typed.isBlank();
    }

    private static Object value(RecordComponent field, String typed) {
        Class<?> type = field.getType();
        String name = field.getName();
        return switch (kind(field.getGenericType()).orElseThrow()) {
            case WORDS -> typed;
            case NUMBER -> type == int.class ? (Object) whole(name, typed) : (Object) number(name, typed);
            case CHOICE -> choice(field, typed);
            case PLACE -> place(name, typed);
            case PLACES ->
                BETWEEN_PLACES
                        .splitAsStream(typed)
                        .map(each -> place(name, each.strip()))
                        .toList();
            case POSE -> {
                double[] all = numbers(name, typed, 3, "x, y [m] and heading [°]: 3 4.5 90");
                yield new Pose2d(all[0], all[1], Math.toRadians(all[2]));
            }
        };
    }

    private static Point2d place(String name, String typed) {
        double[] both = numbers(name, typed, 2, "x and y [m]: 3 4.5");
        return new Point2d(both[0], both[1]);
    }

    private static int whole(String name, String typed) {
        double number = numbers(name, typed, 1, "a whole number")[0];
        if (number != Math.rint(number) || Math.abs(number) > Integer.MAX_VALUE) {
            throw misfit(name, typed, "a whole number");
        }
        return (int) number;
    }

    private static double number(String name, String typed) {
        return numbers(name, typed, 1, "a number")[0];
    }

    private static double[] numbers(String name, String typed, int count, String wanted) {
        try {
            double[] all = BETWEEN_NUMBERS
                    .splitAsStream(typed)
                    .mapToDouble(Double::parseDouble)
                    .toArray();
            if (all.length == count && Arrays.stream(all).allMatch(Double::isFinite)) {
                return all;
            }
        } catch (NumberFormatException _) {
            // said below
        }
        throw misfit(name, typed, wanted);
    }

    private static Object choice(RecordComponent field, String typed) {
        List<String> choices = choices(field.getType());
        if (!choices.contains(typed)) {
            throw misfit(field.getName(), typed, "one of " + choices);
        }
        return field.getType() == boolean.class
                ? (Object) Boolean.valueOf(typed)
                : Objects.requireNonNull(field.getType().getEnumConstants())[choices.indexOf(typed)];
    }

    private static IllegalArgumentException misfit(String name, String typed, String wanted) {
        return new IllegalArgumentException("Field '%s' takes %s, not '%s'.".formatted(name, wanted, typed));
    }
}
