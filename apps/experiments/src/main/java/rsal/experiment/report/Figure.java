package rsal.experiment.report;

import java.util.List;
import java.util.function.Consumer;

/// A figure with the numbers in it.
///
/// @param name of its files
/// @param alternative what it shows, for those who don't see it
/// @param width in pixels, as on a page
/// @param header names of the columns of its numbers
/// @param numbers by row
record Figure(
        String name,
        String alternative,
        int width,
        int height,
        Consumer<Drawing> picture,
        List<String> header,
        List<List<String>> numbers) {
    static final int WIDTH = 900;

    Figure {
        header = List.copyOf(header);
        numbers = List.copyOf(numbers);
    }
}
