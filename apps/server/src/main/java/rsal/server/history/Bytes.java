package rsal.server.history;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.RecordComponent;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.jspecify.annotations.Nullable;

/// About how much memory values take: records, lists, maps, arrays and words, and what is in these.
final class Bytes {
    private static final int OBJECT = 16;
    private static final int REFERENCE = 8;
    private static final int ENTRY = 48; // of a map

    private static final ClassValue<RecordComponent[]> PARTS = new ClassValue<>() {
        @Override
        protected RecordComponent[] computeValue(Class<?> type) {
            return type.getRecordComponents();
        }
    };

    private Bytes() {}

    /// What a value takes beyond another one: nothing where they share an object.
    ///
    /// @param before null for none
    @SuppressWarnings("ReferenceEquality") // what is equal, and another object, takes room
    static long beyond(@Nullable Object before, Object value) {
        if (value == before) {
            return 0;
        }
        return OBJECT
                + switch (value) {
                    case byte[] all -> all.length;
                    case float[] all -> (long) Float.BYTES * all.length;
                    case double[] all -> (long) Double.BYTES * all.length;
                    case String words -> words.length();
                    case Optional<?> some ->
                        some.map(inner ->
                                        beyond(before instanceof Optional<?> other ? other.orElse(null) : null, inner))
                                .orElse(0L);
                    case List<?> all -> list(before instanceof List<?> other ? other : List.of(), all);
                    case Map<?, ?> all -> map(before instanceof Map<?, ?> other ? other : Map.of(), all);
                    case Record record -> record(before, record);
                    default -> 0; // a number, or a word of few
                };
    }

    private static long list(List<?> before, List<?> all) {
        long bytes = 0;
        for (int i = 0; i < all.size(); i++) {
            bytes += REFERENCE + beyond(i < before.size() ? before.get(i) : null, all.get(i));
        }
        return bytes;
    }

    private static long map(Map<?, ?> before, Map<?, ?> all) {
        long bytes = 0;
        for (Map.Entry<?, ?> entry : all.entrySet()) {
            bytes += ENTRY + beyond(before.get(entry.getKey()), entry.getValue());
            bytes += before.containsKey(entry.getKey()) ? 0 : beyond(null, entry.getKey());
        }
        return bytes;
    }

    private static long record(@Nullable Object before, Record record) {
        Record alike = before instanceof Record other && other.getClass().equals(record.getClass()) ? other : null;
        long bytes = 0;
        for (RecordComponent part : PARTS.get(record.getClass())) {
            bytes += REFERENCE;
            if (!part.getType().isPrimitive()) {
                bytes += beyond(alike == null ? null : read(alike, part), read(record, part));
            }
        }
        return bytes;
    }

    private static Object read(Record record, RecordComponent part) {
        try {
            return part.getAccessor().invoke(record);
        } catch (IllegalAccessException | InvocationTargetException _) {
            return ""; // of a kind that nobody else may look into
        }
    }
}
