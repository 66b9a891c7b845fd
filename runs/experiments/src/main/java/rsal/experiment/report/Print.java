package rsal.experiment.report;

import java.awt.Font;
import java.util.Locale;

/// How figures are made for a paper.
///
/// @param millimeters width of a figure, 30 to 1000
/// @param family the font: one that is installed, or `sans-serif`, `serif`, `monospace`
/// @param points height of the font, 4 to 40
public record Print(double millimeters, String family, double points) {
    /// A column of a page with two of them, with the smallest text that most journals take.
    public static final Print COLUMN = new Print(88, "sans-serif", 8);

    private static final double POINTS_PER_MILLIMETER = 72 / 25.4;

    public Print {
        if (!(millimeters >= 30 && millimeters <= 1000)) {
            throw new IllegalArgumentException("A figure is 30 to 1000 mm wide, not '%s'.".formatted(millimeters));
        }
        if (!(points >= 4 && points <= 40)) {
            throw new IllegalArgumentException("The font is 4 to 40 points high, not '%s'.".formatted(points));
        }
        if (logical(family).isEmpty()
                && !new Font(family, Font.PLAIN, 1).getFamily().equalsIgnoreCase(family)) {
            throw new IllegalArgumentException(
                    "The font '%s' is not installed. Name another one, or 'sans-serif', 'serif', 'monospace'."
                            .formatted(family));
        }
    }

    /// Of the figure [pt].
    double widthInPoints() {
        return millimeters * POINTS_PER_MILLIMETER;
    }

    /// Of the figure in the unit of drawings, in which a text is [ReportFigure#TEXT] high.
    double width() {
        return widthInPoints() / points * ReportFigure.TEXT;
    }

    /// In the unit of drawings.
    Font font() {
        String logical = logical(family);
        return new Font(logical.isEmpty() ? family : logical, Font.PLAIN, 1).deriveFont((float) ReportFigure.TEXT);
    }

    private static String logical(String family) {
        return switch (family.toLowerCase(Locale.ROOT)) {
            case "sans-serif" -> Font.SANS_SERIF;
            case "serif" -> Font.SERIF;
            case "monospace" -> Font.MONOSPACED;
            default -> "";
        };
    }
}
