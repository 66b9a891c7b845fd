package rsal.data;

import java.util.Locale;
import java.util.Optional;
import java.util.regex.Pattern;

/// A color, each part 0–255.
public record Rgb(int red, int green, int blue) {
    private static final Pattern HEX = Pattern.compile("#[0-9a-fA-F]{6}");

    public Rgb {
        if (((red | green | blue) & ~0xff) != 0) {
            throw new IllegalArgumentException(
                    "A color's parts are from 0 to 255, not (%d, %d, %d).".formatted(red, green, blue));
        }
    }

    /// @param packed `0xRRGGBB`; what is above does not count
    public static Rgb of(int packed) {
        return new Rgb((packed >> 16) & 0xff, (packed >> 8) & 0xff, packed & 0xff);
    }

    /// Reads `#rrggbb`; empty when it is something else.
    public static Optional<Rgb> parse(String text) {
        return HEX.matcher(text).matches()
                ? Optional.of(of(Integer.parseInt(text.substring(1), 16)))
                : Optional.empty();
    }

    /// `0xRRGGBB`.
    public int packed() {
        return red << 16 | green << 8 | blue;
    }

    /// `#rrggbb`.
    @Override
    public String toString() {
        return String.format(Locale.ROOT, "#%06x", packed());
    }
}
