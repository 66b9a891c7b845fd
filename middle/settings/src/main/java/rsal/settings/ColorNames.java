package rsal.settings;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.TreeMap;
import rsal.data.Rgb;

/// Colors as people write them: `#rrggbb`, or a name of X11's, as worlds of Stage have them.
public final class ColorNames {
    private static final Map<String, Rgb> NAMED = load();

    private ColorNames() {}

    /// A color by its name; case, blanks, and whether it is gray or grey don't count.
    public static Optional<Rgb> named(String name) {
        return Optional.ofNullable(NAMED.get(normal(name)));
    }

    /// All names, in lower case and without blanks.
    public static Set<String> all() {
        return NAMED.keySet();
    }

    /// A color as people write it.
    public static Optional<Rgb> parse(String text) {
        return Rgb.parse(text).or(() -> named(text));
    }

    /// What to try instead of a text that is no color.
    public static String advice(String text) {
        return Suggestion.closest(normal(text), all())
                .map("Maybe '%s' was meant?"::formatted)
                .orElse("Names are those of X11, such as red, orange or gray30.");
    }

    /// What a setting says; an error is noted when that is no color.
    ///
    /// @param read the setting, or one of those that it lists
    public static Optional<Rgb> read(Section section, String key, Value read) {
        String text = read instanceof Value.Scalar scalar ? scalar.value().toString() : "";
        Optional<Rgb> color = parse(text);
        if (color.isEmpty()) {
            section.problem(
                    read.location(),
                    "'%s' must be a color, \"#rrggbb\" or a name, not %s."
                            .formatted(section.path(key), read.describe()),
                    advice(text));
        }
        return color;
    }

    /// Those that a setting lists; none when it is left out.
    public static List<Rgb> list(Section section, String key) {
        return section.list(key).orElse(List.of()).stream()
                .flatMap(item -> read(section, key, item).stream())
                .toList();
    }

    private static String normal(String name) {
        return name.replace(" ", "").toLowerCase(Locale.ROOT).replace("grey", "gray");
    }

    private static Map<String, Rgb> load() {
        var colors = new TreeMap<String, Rgb>();
        try (InputStream in = ColorNames.class.getResourceAsStream("x11-colors.txt")) {
            if (in == null) {
                throw new IllegalStateException("Resource 'x11-colors.txt' is missing.");
            }
            var words = new StringTokenizer(new String(in.readAllBytes(), StandardCharsets.US_ASCII));
            while (words.hasMoreTokens()) {
                String name = words.nextToken();
                colors.put(name, Rgb.of(Integer.parseInt(words.nextToken(), 16)));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return Collections.unmodifiableMap(colors);
    }
}
