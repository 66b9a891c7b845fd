package rsal.ros2.cdr;

import java.lang.reflect.Array;
import java.util.ArrayList;
import java.util.Iterator;
import java.util.List;
import java.util.Objects;
import rsal.ros2.type.Field;
import rsal.ros2.type.FieldType;
import rsal.ros2.type.FieldType.Repeat;
import rsal.ros2.type.Primitive;

/// Writes messages as JSON for people to read: fields in their order, messages within indented. What is not finite is a
/// text (`"NaN"`), as JSON has no such numbers. Long arrays and texts are cut, and say how much is missing.
public final class MessageJson {
    private static final int MOST_ELEMENTS = 128; // of an array
    private static final int MOST_CHARACTERS = 2_000; // of a text
    private static final int MOST_VALUES = 10_000; // of a message, with those within
    private static final String INDENT = "  ";

    private final StringBuilder json = new StringBuilder();
    private int values; // written so far

    private MessageJson() {}

    public static String of(RosMessage message) {
        var writer = new MessageJson();
        writer.write(message, "\n");
        return writer.json.toString();
    }

    /// @param margin a line break, and the indent of the message
    private void write(RosMessage message, String margin) {
        json.append('{');
        String separator = "";
        for (Field field : message.type().fields()) {
            json.append(separator).append(margin).append(INDENT);
            writeText(field.name());
            json.append(": ");
            write(field.type(), Objects.requireNonNull(message.fields().get(field.name())), margin + INDENT);
            separator = ",";
        }
        json.append(margin).append('}');
    }

    private void write(FieldType type, Object value, String margin) {
        if (type.repeat() == Repeat.ONE) {
            writeOne(type, value, margin);
            return;
        }
        List<Object> all = elements(type, value);
        int count = value instanceof List<?> list ? list.size() : Array.getLength(value);
        boolean isWide = !all.isEmpty() && all.getFirst() instanceof RosMessage; // each in lines of its own
        String before = isWide ? margin + INDENT : "";
        json.append('[');
        Iterator<Object> each = all.iterator();
        while (each.hasNext()) {
            json.append(before);
            writeOne(type, each.next(), margin + INDENT);
            json.append(each.hasNext() ? isWide ? "," : ", " : "");
        }
        if (all.size() < count) {
            json.append(all.isEmpty() ? "" : isWide ? "," : ", ").append(before);
            writeText("… %d more".formatted(count - all.size()));
        }
        json.append(isWide ? margin : "").append(']');
    }

    /// Those that are written.
    private List<Object> elements(FieldType type, Object value) {
        int room = Math.clamp(MOST_VALUES - values, 0, MOST_ELEMENTS);
        if (value instanceof List<?> list) {
            return List.copyOf(list.subList(0, Math.min(list.size(), room)));
        }
        var all = new ArrayList<Object>();
        for (int i = 0; i < Math.min(Array.getLength(value), room); i++) {
            Object element = Array.get(value, i);
            all.add(element instanceof Byte bits && type.element() == Primitive.BOOL ? bits != 0 : element);
        }
        return all;
    }

    private void writeOne(FieldType type, Object value, String margin) {
        values++;
        switch (value) {
            case RosMessage message -> write(message, margin);
            case String text -> writeText(text);
            case Boolean flag -> json.append(flag.booleanValue());
            case Double number when type.element() == Primitive.FLOAT32 -> writeNumber(number, number.floatValue());
            case Float number -> writeNumber(number, number);
            case Number number when number instanceof Double -> writeNumber(number.doubleValue(), number);
            case Number number -> json.append(integer(type, number));
            default -> throw new IllegalArgumentException("A message has no '%s'.".formatted(value.getClass()));
        }
    }

    private void writeNumber(double value, Number shown) {
        if (Double.isFinite(value)) {
            json.append(shown);
        } else {
            writeText(shown.toString());
        }
    }

    /// Arrays of unsigned integers have their bits.
    private static String integer(FieldType type, Number number) {
        return switch (type.element()) {
            case Primitive.UINT64 -> Long.toUnsignedString(number.longValue());
            case Primitive.UINT32 -> Long.toString(number.longValue() & 0xffff_ffffL);
            case Primitive.UINT16 -> Long.toString(number.longValue() & 0xffff);
            case Primitive.UINT8, Primitive.BYTE -> Long.toString(number.longValue() & 0xff);
            default -> number.toString();
        };
    }

    private void writeText(String text) {
        json.append('"');
        int shown = Math.min(text.length(), MOST_CHARACTERS);
        for (int i = 0; i < shown; i++) {
            char c = text.charAt(i);
            switch (c) {
                case '"', '\\' -> json.append('\\').append(c);
                case '\n' -> json.append("\\n");
                case '\t' -> json.append("\\t");
                default -> {
                    if (Character.isISOControl(c) || (Character.isSurrogate(c) && isAlone(text, i))) {
                        json.append("\\u%04x".formatted((int) c));
                    } else {
                        json.append(c);
                    }
                }
            }
        }
        if (shown < text.length()) {
            json.append("… %d more".formatted(text.length() - shown));
        }
        json.append('"');
    }

    /// Whether a half of a character lacks the other one, as where a text is cut.
    private static boolean isAlone(String text, int at) {
        return Character.isHighSurrogate(text.charAt(at))
                ? at + 1 >= Math.min(text.length(), MOST_CHARACTERS) || !Character.isLowSurrogate(text.charAt(at + 1))
                : at == 0 || !Character.isHighSurrogate(text.charAt(at - 1));
    }
}
