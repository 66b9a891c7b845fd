package rsal.experiment.report;

import java.util.ArrayList;
import java.util.List;
import java.util.function.BiConsumer;
import rsal.experiment.report.Drawing.Align;
import rsal.experiment.report.Drawing.Ink;

/// Where the parts of a figure are: keys above, labels to the left of their rows, and a scale below. In a narrow
/// figure labels take two lines, and keys several.
///
/// @param labels of the rows; none where the figure has no rows
/// @param keys what the marks mean
record FigureLayout(double width, List<String> labels, List<Mark> keys) {
    static final int ROW = 34;
    private static final int ABOVE = 8; // the keys
    private static final int KEY = 20; // height of a line of them
    private static final int TITLE = 22; // height of what is said above an axis
    private static final int BELOW = 48; // the last row: the scale
    private static final int LONGEST = 44; // letters of a label
    private static final double MOST_LABEL = 0.4; // of the width
    private static final double LINE = 14; // height of one of a label
    private static final double LETTER = 8; // width of one in a wide font
    private static final double MEAN_LETTER = 7;
    private static final int SAMPLE = 30; // width of the mark before a key's text

    /// @param sample draws the mark around a point, 22 wide
    record Mark(String text, BiConsumer<Drawing, Point> sample) {
        private double width() {
            return SAMPLE + MEAN_LETTER * text.length() + 24;
        }
    }

    record Point(double x, double y) {}

    double left() {
        return labels.isEmpty()
                ? 48
                : 16
                        + LETTER
                                * labels.stream()
                                        .flatMap(label -> lines(label).stream())
                                        .mapToInt(String::length)
                                        .max()
                                        .orElse(0);
    }

    double right() {
        return width - Math.min(30, 0.04 * width);
    }

    double top() {
        int lines = 1 + (int) placed().stream().mapToDouble(Placed::line).max().orElse(-1);
        return ABOVE + KEY * lines + (labels.isEmpty() ? TITLE : 6);
    }

    double bottom() {
        return bottom(labels.size() * ROW);
    }

    double bottom(double height) {
        return top() + height;
    }

    double height() {
        return height(labels.size() * ROW);
    }

    double height(double between) {
        return bottom(between) + BELOW;
    }

    double middle(int row) {
        return top() + row * ROW + ROW / 2.0;
    }

    void draw(Drawing drawing) {
        for (int i = 0; i < labels.size(); i++) {
            List<String> lines = lines(labels.get(i));
            for (int line = 0; line < lines.size(); line++) {
                double y = middle(i) + 4 + LINE * (line - (lines.size() - 1) / 2.0);
                drawing.text(left() - 10, y, lines.get(line), Align.END, Ink.TEXT);
            }
        }
        for (Placed key : placed()) {
            double y = ABOVE + key.line() * KEY + 6;
            key.key().sample().accept(drawing, new Point(key.x() + 11, y));
            drawing.text(key.x() + SAMPLE, y + 5, key.key().text(), Align.START, Ink.QUIET);
        }
    }

    private record Placed(Mark key, double x, double line) {}

    private List<Placed> placed() {
        double begin = width > 600 ? left() : 8;
        var placed = new ArrayList<Placed>();
        double x = begin;
        int line = 0;
        for (Mark key : keys) {
            if (x > begin && x + key.width() > width) {
                x = begin;
                line++;
            }
            placed.add(new Placed(key, x, line));
            x += key.width();
        }
        return placed;
    }

    /// Of a label that is too long, two, parted at a comma or a space; what is still too long is cut.
    private List<String> lines(String label) {
        int most = (int) Math.min(LONGEST, MOST_LABEL * width / LETTER);
        int comma = label.lastIndexOf(", ", most) + 1;
        int parted = comma > 0 ? comma : label.lastIndexOf(' ', most);
        return label.length() <= most || parted <= 0
                ? List.of(shortened(label, most))
                : List.of(label.substring(0, parted), shortened(label.substring(parted + 1), most));
    }

    private static String shortened(String text, int most) {
        return text.length() > most ? text.substring(0, most - 1) + "…" : text;
    }
}
