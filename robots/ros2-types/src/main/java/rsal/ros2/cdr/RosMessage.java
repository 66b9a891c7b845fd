package rsal.ros2.cdr;

import java.util.Collections;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import rsal.ros2.type.RosType;

/// A message of any type, field by field. Handed over, not copied: arrays must not be changed afterwards.
///
/// | field | value |
/// |---|---|
/// | `bool` | [Boolean] |
/// | integers | [Long]; of `uint64` the bits |
/// | `float32`, `float64` | [Double] |
/// | `string` | [String] |
/// | message | [RosMessage] |
/// | several `int8`, `uint8`, `byte`, `bool` | `byte[]` |
/// | several `int16`, `int32`, `int64` and unsigned ones | `short[]`, `int[]`, `long[]`, unsigned ones by their bits |
/// | several `float32`, `float64` | `float[]`, `double[]` |
/// | several texts, messages | a [List] |
///
/// @param fields by name, in the order of the type
public record RosMessage(RosType type, Map<String, Object> fields) {
    public RosMessage {
        fields = Collections.unmodifiableMap(new LinkedHashMap<>(fields));
    }

    /// The value of a field.
    ///
    /// @throws NullPointerException when the type has no such field
    /// @throws ClassCastException when it is of another type
    public <T> T get(String field, Class<T> type) {
        return type.cast(Objects.requireNonNull(fields.get(field), () -> "There is no field '%s'.".formatted(field)));
    }

    /// The same message with another value of one field.
    ///
    /// @throws IllegalArgumentException when the type has no such field
    public RosMessage with(String field, Object value) {
        if (!fields.containsKey(field)) {
            throw new IllegalArgumentException("'%s' has no field '%s'.".formatted(type.name(), field));
        }
        var changed = new LinkedHashMap<>(fields);
        changed.put(field, value);
        return new RosMessage(type, changed);
    }

    public RosMessage message(String field) {
        return get(field, RosMessage.class);
    }

    public List<RosMessage> messages(String field) {
        List<?> all = get(field, List.class);
        return all.stream().map(RosMessage.class::cast).toList();
    }

    public String text(String field) {
        return get(field, String.class);
    }

    public long integer(String field) {
        return get(field, Long.class);
    }

    public double number(String field) {
        return get(field, Double.class);
    }
}
