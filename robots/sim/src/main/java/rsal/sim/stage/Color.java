package rsal.sim.stage;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.Collections;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.StringTokenizer;
import java.util.TreeMap;

/// A color, each part 0–255.
///
/// @param alpha 255 is opaque
public record Color(int red, int green, int blue, int alpha) {
    /// What Stage takes for colors that nobody names.
    public static final Color RED = new Color(255, 0, 0, 255);

    static final Color BLUE = new Color(0, 0, 255, 255);
    static final Color GREEN = new Color(0, 255, 0, 255);

    private static final Map<String, Color> NAMED = read();

    /// `0xRRGGBB`.
    public int rgb() {
        return red << 16 | green << 8 | blue;
    }

    /// A color by its name in X11; case, blanks, and whether it is gray or grey don't count.
    static Optional<Color> named(String name) {
        return Optional.ofNullable(NAMED.get(normal(name)));
    }

    static Set<String> names() {
        return NAMED.keySet();
    }

    /// @param parts red, green, blue, alpha from 0 to 1; what is beyond is cut
    static Color of(double[] parts) {
        return new Color(part(parts[0]), part(parts[1]), part(parts[2]), part(parts[3]));
    }

    private static int part(double share) {
        return (int) Math.round(Math.clamp(share, 0.0, 1.0) * 255);
    }

    private static String normal(String name) {
        return name.replace(" ", "").toLowerCase(Locale.ROOT).replace("grey", "gray");
    }

    private static Map<String, Color> read() {
        var colors = new TreeMap<String, Color>();
        try (InputStream in = Color.class.getResourceAsStream("x11-colors.txt")) {
            if (in == null) {
                throw new IllegalStateException("Resource (x11-colors.txt) is missing.");
            }
            var words = new StringTokenizer(new String(in.readAllBytes(), StandardCharsets.US_ASCII));
            while (words.hasMoreTokens()) {
                String name = words.nextToken();
                int rgb = Integer.parseInt(words.nextToken(), 16);
                colors.put(name, new Color(rgb >> 16, rgb >> 8 & 0xff, rgb & 0xff, 255));
            }
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return Collections.unmodifiableMap(colors);
    }
}
