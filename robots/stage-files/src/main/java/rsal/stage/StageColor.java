package rsal.stage;

import java.util.Optional;
import java.util.Set;
import rsal.settings.ColorNames;

/// A color, each part 0–255.
///
/// @param alpha 255 is opaque
public record StageColor(int red, int green, int blue, int alpha) {
    /// What Stage takes for colors that nobody names.
    public static final StageColor RED = new StageColor(255, 0, 0, 255);

    static final StageColor BLUE = new StageColor(0, 0, 255, 255);
    static final StageColor GREEN = new StageColor(0, 255, 0, 255);

    /// `0xRRGGBB`.
    public int rgb() {
        return red << 16 | green << 8 | blue;
    }

    /// A color by its name in X11; case, blanks, and whether it is gray or grey don't count.
    static Optional<StageColor> named(String name) {
        return ColorNames.named(name).map(rgb -> new StageColor(rgb.red(), rgb.green(), rgb.blue(), 255));
    }

    static Set<String> names() {
        return ColorNames.all();
    }

    /// @param parts red, green, blue, alpha from 0 to 1; what is beyond is cut
    static StageColor of(double[] parts) {
        return new StageColor(part(parts[0]), part(parts[1]), part(parts[2]), part(parts[3]));
    }

    private static int part(double share) {
        return (int) Math.round(Math.clamp(share, 0.0, 1.0) * 255);
    }
}
