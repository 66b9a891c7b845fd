package rsal.experiment.report;

import java.util.ArrayList;
import java.util.List;
import rsal.experiment.report.Drawing.Align;
import rsal.experiment.report.Drawing.Ink;

/// Where numbers are from left to right.
///
/// @param left of the least number, in pixels
/// @param right of the greatest, in pixels
record Scale(double least, double most, double left, double right) {
    private static final int TICKS = 6; // about
    private static final double TICK = 60; // least pixels from one to the next
    private static final double LETTER = 7; // mean width of one [px]
    private static final double MARGIN = 0.03; // of the range, on both sides

    /// One on which all of some numbers have room.
    static Scale of(double least, double most, double left, double right) {
        if (least == 0 && most == 0) {
            return new Scale(-MARGIN, 1 + MARGIN, left, right); // a count of what never happened
        }
        double margin = most > least ? MARGIN * (most - least) : Math.abs(most) * 0.1;
        return new Scale(least - margin, most + margin, left, right);
    }

    double at(double value) {
        return left + (value - least) / (most - least) * (right - left);
    }

    /// Round numbers: multiples of 1, 2 or 5 times a power of ten.
    List<Double> ticks() {
        double rough = (most - least) / Math.clamp((right - left) / TICK, 1, TICKS);
        double power = Math.pow(10, Math.floor(Math.log10(rough)));
        double step = power * (rough / power < 1.5 ? 1 : rough / power < 3.5 ? 2 : rough / power < 7.5 ? 5 : 10);
        var ticks = new ArrayList<Double>();
        for (double n = Math.ceil(least / step); n * step <= most; n++) {
            ticks.add(n * step + 0.0); // no negative zero
        }
        return ticks;
    }

    /// @param top of the lines through the figure, in pixels
    /// @param bottom of them, with the numbers below, in pixels
    void draw(Drawing drawing, double top, double bottom, String title) {
        for (double tick : ticks()) {
            drawing.line(at(tick), top, at(tick), bottom, 1, Ink.GRID);
            drawing.text(at(tick), bottom + 17, label(tick), Align.MIDDLE, Ink.QUIET);
        }
        double half = Math.min(title.length() * LETTER / 2, right / 2);
        drawing.text(
                Math.max((left + right) / 2 - Math.max(0, (left + right) / 2 + half - right), half),
                bottom + 38,
                title,
                Align.MIDDLE,
                Ink.TEXT);
    }

    private static String label(double tick) {
        double tidy = Math.abs(tick) < 1e-12 ? 0 : Double.parseDouble("%.10g".formatted(tick));
        String text = tidy == Math.rint(tidy) && Math.abs(tidy) < 1e6 ? Long.toString((long) tidy) : "" + (float) tidy;
        return text.replace("-", "−");
    }
}
