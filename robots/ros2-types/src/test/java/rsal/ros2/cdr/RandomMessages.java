package rsal.ros2.cdr;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.SplittableRandom;
import rsal.ros2.type.Element;
import rsal.ros2.type.Field;
import rsal.ros2.type.FieldType;
import rsal.ros2.type.Primitive;
import rsal.ros2.type.RosType;
import rsal.ros2.type.TypeLibrary;

/// Messages of any type, with values that may be anything.
final class RandomMessages {
    private static final int MOST_ELEMENTS = 4;

    private final SplittableRandom random;
    private final TypeLibrary library;

    RandomMessages(long seed, TypeLibrary library) {
        this.random = new SplittableRandom(seed);
        this.library = library;
    }

    RosMessage of(RosType type) {
        var fields = new LinkedHashMap<String, Object>();
        for (Field field : type.fields()) {
            fields.put(field.name(), value(field.type()));
        }
        return new RosMessage(type, fields);
    }

    private Object value(FieldType type) {
        return switch (type.repeat()) {
            case ONE -> one(type.element());
            case ARRAY -> all(type.element(), type.count());
            case BOUNDED -> all(type.element(), random.nextInt(Math.min(type.count(), MOST_ELEMENTS) + 1));
            case ANY -> all(type.element(), random.nextInt(MOST_ELEMENTS + 1));
        };
    }

    private Object one(Element element) {
        return switch (element) {
            case Element.Nested(String name) -> of(library.get(name));
            case Element.Text _ -> text();
            case Primitive primitive ->
                switch (primitive) {
                    case BOOL -> random.nextBoolean();
                    case INT8 -> (long) (byte) random.nextInt();
                    case BYTE, UINT8 -> (long) random.nextInt(256);
                    case INT16 -> (long) (short) random.nextInt();
                    case UINT16 -> (long) random.nextInt(65536);
                    case INT32 -> (long) random.nextInt();
                    case UINT32 -> random.nextLong(1L << 32);
                    case INT64, UINT64 -> random.nextLong();
                    case FLOAT32 -> (double) (random.nextFloat() * 100 - 50);
                    case FLOAT64 -> random.nextDouble() * 100 - 50;
                };
        };
    }

    private Object all(Element element, int count) {
        if (!(element instanceof Primitive primitive)) {
            var list = new ArrayList<Object>();
            for (int i = 0; i < count; i++) {
                list.add(one(element));
            }
            return list;
        }
        return switch (primitive) {
            case BOOL, BYTE, INT8, UINT8 -> {
                var bytes = new byte[count];
                for (int i = 0; i < count; i++) {
                    bytes[i] = (byte) random.nextInt();
                }
                yield bytes;
            }
            case INT16, UINT16 -> {
                var shorts = new short[count];
                for (int i = 0; i < count; i++) {
                    shorts[i] = (short) random.nextInt();
                }
                yield shorts;
            }
            case INT32, UINT32 -> random.ints(count).toArray();
            case INT64, UINT64 -> random.longs(count).toArray();
            case FLOAT32 -> {
                var floats = new float[count];
                for (int i = 0; i < count; i++) {
                    floats[i] = random.nextFloat();
                }
                yield floats;
            }
            case FLOAT64 -> random.doubles(count).toArray();
        };
    }

    private String text() {
        var text = new StringBuilder();
        int length = random.nextInt(7);
        for (int i = 0; i < length; i++) {
            text.append("aé漢 /_".charAt(random.nextInt(6)));
        }
        return text.toString();
    }
}
