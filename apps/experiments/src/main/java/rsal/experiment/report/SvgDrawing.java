package rsal.experiment.report;

import java.util.Locale;

/// A drawing as SVG inside a page, which gives it its colors, light or dark, by classes.
final class SvgDrawing implements Drawing {
    private final StringBuilder svg = new StringBuilder();

    static String of(Figure figure) {
        var drawing = new SvgDrawing();
        drawing.svg.append("<svg viewBox=\"0 0 %d %d\" width=\"%d\" role=\"img\" aria-label=\"%s\">%n"
                .formatted(figure.width(), figure.height(), figure.width(), Html.text(figure.alternative())));
        figure.picture().accept(drawing);
        return drawing.svg.append("</svg>\n").toString();
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Ink ink) {
        add("<line class=\"stroke %s\" x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\" stroke-width=\"%s\"/>"
                .formatted(ink.word(), number(x1), number(y1), number(x2), number(y2), number(width)));
    }

    @Override
    public void bar(double x, double y, double width, double height, Ink ink) {
        add("<rect class=\"fill %s\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"/>"
                .formatted(ink.word(), number(x), number(y), number(width), number(height)));
    }

    @Override
    public void box(double x, double y, double width, double height, Ink ink) {
        add("<rect class=\"box %s\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"/>"
                .formatted(ink.word(), number(x), number(y), number(width), number(height)));
    }

    @Override
    public void dot(double x, double y, double radius, Ink ink) {
        add("<circle class=\"fill %s\" cx=\"%s\" cy=\"%s\" r=\"%s\"/>"
                .formatted(ink.word(), number(x), number(y), number(radius)));
    }

    @Override
    public void ring(double x, double y, double radius, Ink ink) {
        add("<circle class=\"stroke %s\" cx=\"%s\" cy=\"%s\" r=\"%s\"/>"
                .formatted(ink.word(), number(x), number(y), number(radius)));
    }

    @Override
    public void text(double x, double y, String text, Align align, Ink ink) {
        add("<text class=\"fill %s\" x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>"
                .formatted(ink.word(), number(x), number(y), align.name().toLowerCase(Locale.ROOT), Html.text(text)));
    }

    private void add(String element) {
        svg.append(element).append('\n');
    }

    private static String number(double value) {
        return String.format(Locale.ROOT, "%.1f", value);
    }
}
