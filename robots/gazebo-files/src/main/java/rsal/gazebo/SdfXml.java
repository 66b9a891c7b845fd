package rsal.gazebo;

import java.math.BigDecimal;
import java.math.RoundingMode;

/// Writes XML, an element a line, indented.
final class SdfXml {
    private final StringBuilder text = new StringBuilder("<?xml version=\"1.0\"?>\n");
    private int depth;

    /// Writes a comment.
    SdfXml comment(String comment) {
        return line("<!-- " + escaped(comment).replace("--", "- -") + " -->");
    }

    /// Begins an element.
    ///
    /// @param attributes names and values in turn
    SdfXml open(String name, String... attributes) {
        line("<" + name + written(attributes) + ">");
        depth++;
        return this;
    }

    /// Ends an element.
    SdfXml close(String name) {
        depth--;
        return line("</" + name + ">");
    }

    /// An element with a text.
    SdfXml leaf(String name, String content, String... attributes) {
        return line("<" + name + written(attributes) + ">" + escaped(content) + "</" + name + ">");
    }

    /// An element with numbers.
    SdfXml numbers(String name, double... numbers) {
        var content = new StringBuilder();
        for (double number : numbers) {
            content.append(content.isEmpty() ? "" : " ").append(plain(number));
        }
        return leaf(name, content.toString());
    }

    private static String written(String... attributes) {
        var written = new StringBuilder();
        for (int i = 0; i < attributes.length; i += 2) {
            written.append(" %s=\"%s\"".formatted(attributes[i], escaped(attributes[i + 1])));
        }
        return written.toString();
    }

    private SdfXml line(String line) {
        text.append("  ".repeat(depth)).append(line).append('\n');
        return this;
    }

    /// To a billionth.
    private static String plain(double number) {
        String plain = new BigDecimal(number)
                .setScale(9, RoundingMode.HALF_EVEN)
                .stripTrailingZeros()
                .toPlainString();
        return plain.equals("-0") ? "0" : plain;
    }

    /// Characters that XML can't have become `?`.
    private static String escaped(String text) {
        var escaped = new StringBuilder();
        text.codePoints().forEach(c -> {
            switch (c) {
                case '<' -> escaped.append("&lt;");
                case '>' -> escaped.append("&gt;");
                case '&' -> escaped.append("&amp;");
                case '"' -> escaped.append("&quot;");
                default -> escaped.appendCodePoint(isWritable(c) ? c : '?');
            }
        });
        return escaped.toString();
    }

    private static boolean isWritable(int c) {
        return c >= 0x20 && c != 0x7f && !(c >= 0xd800 && c < 0xe000) && c != 0xfffe && c != 0xffff;
    }

    @Override
    public String toString() {
        return text.toString();
    }
}
