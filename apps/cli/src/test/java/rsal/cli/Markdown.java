package rsal.cli;

import java.util.List;
import java.util.Locale;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Collectors;
import java.util.stream.Stream;

/// Markdown as GitHub and the site both read it.
final class Markdown {
    private static final Pattern TYPED = Pattern.compile("(?<!\\w)'([^' ][^']*)'(?!\\w)|(?<!\\S)--[a-z-]+");

    private Markdown() {}

    /// A text of the program, in which `'words'` and `--options` are what somebody types.
    static String text(String plain) {
        return TYPED.matcher(plain.replace("|", "\\|").replace("<", "&lt;"))
                .replaceAll(typed -> Matcher.quoteReplacement(
                        "`" + (typed.group(1) == null ? typed.group() : typed.group(1)) + "`"));
    }

    static String code(String exact) {
        return "`" + exact.replace("|", "\\|") + "`";
    }

    /// As one would write it in YAML: `0.5`, `office`, `""`.
    static String value(Object value) {
        boolean whole = value instanceof Double number && number == Math.rint(number) && Math.abs(number) < 1e15;
        return code(whole ? Long.toString(((Double) value).longValue()) : value.equals("") ? "\"\"" : value.toString());
    }

    /// What GitHub and the site call the place of a heading.
    static String anchor(String heading) {
        return heading.toLowerCase(Locale.ROOT)
                .replaceAll("[^\\p{L}\\p{N} _-]", "")
                .replace(' ', '-');
    }

    /// Up to its end or the first full stop.
    static String firstSentence(String text) {
        int end = text.indexOf(". ");
        return end < 0 ? text : text.substring(0, end + 1);
    }

    static final class Table {
        private final StringBuilder lines = new StringBuilder();

        Table(String... heading) {
            row(heading);
            row(Stream.of(heading).map(_ -> "---").toArray(String[]::new));
        }

        void row(String... cells) {
            lines.append(List.of(cells).stream()
                    .map(cell -> cell.isEmpty() ? " " : " " + cell + " ")
                    .collect(Collectors.joining("|", "|", "|\n")));
        }

        @Override
        public String toString() {
            return lines.toString();
        }
    }
}
