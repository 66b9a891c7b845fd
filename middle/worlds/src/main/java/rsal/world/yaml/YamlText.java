package rsal.world.yaml;

import java.math.BigDecimal;
import java.math.RoundingMode;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.regex.Pattern;

/// Writes settings as YAML, short groups on one line.
final class YamlText {
    private static final int WIDTH = 120;
    private static final int SEARCHED = 16; // numbers to each side of a guess
    private static final Pattern PLAIN = Pattern.compile("[A-Za-z][A-Za-z0-9_-]*(\\.[A-Za-z0-9_-]+)*");
    private static final List<String> OTHER_WORDS =
            List.of("true", "false", "null", "y", "n", "yes", "no", "on", "off");

    private final StringBuilder text = new StringBuilder();

    /// Adds a setting.
    ///
    /// @param value a map, a list, a text, a boolean, or a number
    void add(String key, Object value) {
        add(0, scalar(key) + ":", value);
    }

    @Override
    public String toString() {
        return text.toString();
    }

    private void add(int indent, String key, Object value) {
        String flow = flow(value);
        String start = " ".repeat(indent) + key + " ";
        if (start.length() + flow.length() <= WIDTH || !(value instanceof Map || value instanceof List)) {
            text.append(start).append(flow).append('\n');
        } else if (value instanceof Map<?, ?> map) {
            text.append(" ".repeat(indent)).append(key).append('\n');
            map.forEach((name, inner) -> add(indent + 2, scalar(String.valueOf(name)) + ":", inner));
        } else if (value instanceof List<?> list) {
            if (list.stream().allMatch(Map.class::isInstance)) {
                text.append(" ".repeat(indent)).append(key).append('\n');
                list.forEach(item -> addItem(indent + 2, (Map<?, ?>) item));
            } else {
                addWrapped(indent, start, list);
            }
        }
    }

    private void addItem(int indent, Map<?, ?> item) {
        String flow = flow(item);
        if (indent + 2 + flow.length() <= WIDTH) {
            text.append(" ".repeat(indent)).append("- ").append(flow).append('\n');
            return;
        }
        boolean first = true;
        for (Map.Entry<?, ?> entry : item.entrySet()) {
            String key = (first ? "- " : "  ") + scalar(String.valueOf(entry.getKey())) + ":";
            add(indent, key, entry.getValue());
            first = false;
        }
    }

    /// A list that goes on over several lines.
    private void addWrapped(int indent, String start, List<?> list) {
        String next = " ".repeat(indent + 4);
        var line = new StringBuilder(start).append('[');
        for (int i = 0; i < list.size(); i++) {
            String item = flow(list.get(i)) + (i + 1 < list.size() ? "," : "]");
            if (line.length() + 1 + item.length() > WIDTH) {
                text.append(line.toString().stripTrailing()).append('\n');
                line = new StringBuilder(next);
            }
            line.append(item).append(' ');
        }
        text.append(line.toString().stripTrailing()).append('\n');
    }

    private static String flow(Object value) {
        return switch (value) {
            case Map<?, ?> map -> {
                var items = map.entrySet().stream()
                        .map(e -> scalar(String.valueOf(e.getKey())) + ": " + flow(e.getValue()))
                        .toList();
                yield "{" + String.join(", ", items) + "}";
            }
            case List<?> list ->
                "[" + String.join(", ", list.stream().map(YamlText::flow).toList()) + "]";
            case Double number -> number(number);
            case String word -> scalar(word);
            default -> value.toString();
        };
    }

    /// Reads back as the same number, bit for bit.
    private static String number(double value) {
        if (value == Math.rint(value) && Math.abs(value) < 1e15 && !(value == 0 && 1 / value < 0)) {
            return Long.toString((long) value);
        }
        return Double.toString(value);
    }

    private static String scalar(String word) {
        if (PLAIN.matcher(word).matches() && !OTHER_WORDS.contains(word.toLowerCase(java.util.Locale.ROOT))) {
            return word;
        }
        var quoted = new StringBuilder("\"");
        for (int i = 0; i < word.length(); i++) {
            char c = word.charAt(i);
            switch (c) {
                case '"', '\\' -> quoted.append('\\').append(c);
                default -> {
                    boolean odd = c < ' ' || (c >= 0x7f && c < 0xa0) || c == '\u2028' || c == '\u2029' || c == '\ufeff';
                    quoted.append(odd ? "\\u%04x".formatted((int) c) : String.valueOf(c));
                }
            }
        }
        return quoted.append('"').toString();
    }

    /// The number of which a reader makes another: a short one, if one of those will do.
    ///
    /// @param read what the reader does
    /// @param guess about the number
    static double inverse(double target, DoubleUnaryOperator read, double guess) {
        if (!Double.isFinite(guess)) {
            return guess;
        }
        for (int digits = 0; digits <= 12; digits++) {
            double rounded = BigDecimal.valueOf(guess)
                    .setScale(digits, RoundingMode.HALF_EVEN)
                    .doubleValue();
            if (read.applyAsDouble(rounded) == target) {
                return rounded;
            }
        }
        double up = guess;
        double down = guess;
        for (int i = 0; i < SEARCHED; i++) {
            if (read.applyAsDouble(up) == target) {
                return up;
            }
            if (read.applyAsDouble(down) == target) {
                return down;
            }
            up = Math.nextUp(up);
            down = Math.nextDown(down);
        }
        return guess;
    }

    /// An angle as people type it.
    static double degrees(double radians) {
        return inverse(radians, Math::toRadians, Math.toDegrees(radians));
    }
}
