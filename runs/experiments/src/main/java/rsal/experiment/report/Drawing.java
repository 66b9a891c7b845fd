package rsal.experiment.report;

import java.util.Locale;

/// Something to draw figures on. Lengths are in pixels of the figure, y goes down.
interface Drawing {
    /// What something is drawn for; each drawing has its own colors.
    enum Ink {
        TEXT,
        QUIET,
        GRID,
        DATA,
        MEAN,
        SUCCESS,
        FAILURE,
        TIMEOUT,
        LIMIT,
        BROKEN,
        CURVE1,
        CURVE2,
        CURVE3,
        CURVE4,
        CURVE5,
        CURVE6,
        /// What stands on a bar of any of the colors above.
        ON_BAR;

        String word() {
            return name().toLowerCase(Locale.ROOT).replace('_', '-');
        }
    }

    enum Align {
        START,
        MIDDLE,
        END
    }

    void line(double x1, double y1, double x2, double y2, double width, Ink ink);

    /// A filled rectangle.
    void bar(double x, double y, double width, double height, Ink ink);

    /// A faintly filled rectangle without an outline.
    void band(double x, double y, double width, double height, Ink ink);

    /// A rectangle with an outline, faintly filled.
    void box(double x, double y, double width, double height, Ink ink);

    void dot(double x, double y, double radius, Ink ink);

    void ring(double x, double y, double radius, Ink ink);

    /// @param y of the base line
    void text(double x, double y, String text, Align align, Ink ink);
}
