package rsal.experiment.report;

import java.util.List;
import java.util.Locale;

/// A figure with the numbers in it, that can be drawn in any width.
///
/// @param name of its files
/// @param alternative what it shows, for those who don't see it
/// @param header names of the columns of its numbers
/// @param numbers by row
record ReportFigure(String name, String alternative, Picture picture, List<String> header, List<List<String>> numbers) {
    /// On the page, in pixels of a text that is 13 high.
    static final double WIDTH = 900;

    /// Height of its text in the unit of its lengths.
    static final double TEXT = 13;

    ReportFigure {
        name = fileName(name);
        header = List.copyOf(header);
        numbers = List.copyOf(numbers);
    }

    /// What is in it. Lengths are in pixels of a text that is [#TEXT] high.
    interface Picture {
        double height(double width);

        void draw(Drawing drawing, double width);
    }

    /// What files are called by it.
    static String fileName(String name) {
        return name.replaceAll("[^A-Za-z0-9.-]", "_").toLowerCase(Locale.ROOT);
    }
}
