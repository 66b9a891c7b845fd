package rsal.ros2.type;

import java.util.Arrays;
import java.util.Locale;
import java.util.Optional;

/// Types of one number or truth value.
public enum Primitive implements Element {
    BOOL(1, 15),
    BYTE(1, 16),
    INT8(1, 2),
    UINT8(1, 3),
    INT16(2, 4),
    UINT16(2, 5),
    INT32(4, 6),
    UINT32(4, 7),
    INT64(8, 8),
    UINT64(8, 9),
    FLOAT32(4, 10),
    FLOAT64(8, 11);

    private static final String CHAR = "char"; // means uint8 in .msg files

    private final int size;
    private final int id;

    Primitive(int size, int id) {
        this.size = size;
        this.id = id;
    }

    /// In bytes, which is also how CDR aligns it.
    public int size() {
        return size;
    }

    /// Its number in `type_description_interfaces/msg/FieldType`.
    int id() {
        return id;
    }

    /// As definitions have it: `float64`.
    String text() {
        return name().toLowerCase(Locale.ROOT);
    }

    static Optional<Primitive> named(String name) {
        return name.equals(CHAR)
                ? Optional.of(UINT8)
                : Arrays.stream(values())
                        .filter(each -> each.text().equals(name))
                        .findFirst();
    }
}
