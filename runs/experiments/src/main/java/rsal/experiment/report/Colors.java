package rsal.experiment.report;

import java.awt.Color;
import rsal.experiment.report.Drawing.Ink;

/// Colors on white, as the page has them when it is light. Those of curves differ for people who don't tell red from
/// green: M. Okabe, K. Ito, Color universal design, 2008.
final class Colors {
    private Colors() {}

    static Color of(Ink ink) {
        return switch (ink) {
            case TEXT, ON_BAR -> new Color(0x1a1a1a);
            case QUIET -> new Color(0x595959);
            case GRID -> new Color(0xdddddd);
            case DATA -> new Color(0x0072b2);
            case MEAN -> new Color(0xb34700);
            case SUCCESS -> new Color(0x35b08a);
            case FAILURE -> new Color(0xe2753a);
            case TIMEOUT -> new Color(0xf0b840);
            case LIMIT -> new Color(0x7cc3ec);
            case BROKEN -> new Color(0xa6a6a6);
            case CURVE1 -> new Color(0x0072b2);
            case CURVE2 -> new Color(0xd55e00);
            case CURVE3 -> new Color(0x009e73);
            case CURVE4 -> new Color(0xcc79a7);
            case CURVE5 -> new Color(0xb8860b);
            case CURVE6 -> new Color(0x56b4e9);
        };
    }

    /// `#0072b2`
    static String hex(Ink ink) {
        return "#%06x".formatted(of(ink).getRGB() & 0xffffff);
    }
}
