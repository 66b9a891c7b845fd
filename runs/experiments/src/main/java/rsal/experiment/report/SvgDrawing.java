package rsal.experiment.report;

import java.util.Locale;

/// A drawing as SVG: inside a page, which gives it its colors, light or dark, by classes; or as a file of its own for
/// a paper, in colors on white.
final class SvgDrawing implements Drawing {
    private final StringBuilder svg = new StringBuilder();
    private final boolean inPage;

    private SvgDrawing(boolean inPage) {
        this.inPage = inPage;
    }

    /// Inside a page.
    static String of(ReportFigure figure) {
        var drawing = new SvgDrawing(true);
        drawing.svg.append("<svg viewBox=\"0 0 %s %s\" width=\"%s\" role=\"img\" aria-label=\"%s\">%n"
                .formatted(
                        number(ReportFigure.WIDTH),
                        number(figure.picture().height(ReportFigure.WIDTH)),
                        number(ReportFigure.WIDTH),
                        Html.text(figure.alternative())));
        figure.picture().draw(drawing, ReportFigure.WIDTH);
        return drawing.svg.append("</svg>\n").toString();
    }

    /// A file of its own.
    static String of(ReportFigure figure, Print print) {
        double width = print.width();
        double height = figure.picture().height(width);
        var drawing = new SvgDrawing(false);
        drawing.svg.append("""
                <svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 %s %s" width="%smm" height="%smm" font-family="%s" font-size="%s" role="img">
                <title>%s</title>
                """.formatted(
                        number(width),
                        number(height),
                        number(print.millimeters()),
                        number(print.millimeters() * height / width),
                        Html.text(print.family()),
                        number(ReportFigure.TEXT),
                        Html.text(figure.alternative())));
        figure.picture().draw(drawing, width);
        return drawing.svg.append("</svg>\n").toString();
    }

    @Override
    public void line(double x1, double y1, double x2, double y2, double width, Ink ink) {
        add("<line %s x1=\"%s\" y1=\"%s\" x2=\"%s\" y2=\"%s\" stroke-width=\"%s\"/>"
                .formatted(stroke(ink), number(x1), number(y1), number(x2), number(y2), number(width)));
    }

    @Override
    public void bar(double x, double y, double width, double height, Ink ink) {
        rectangle(fill(ink), x, y, width, height);
    }

    @Override
    public void band(double x, double y, double width, double height, Ink ink) {
        rectangle(fill(ink) + " fill-opacity=\".11\"", x, y, width, height);
    }

    @Override
    public void box(double x, double y, double width, double height, Ink ink) {
        rectangle(
                inPage
                        ? "class=\"box %s\"".formatted(ink.word())
                        : "stroke=\"%s\" stroke-width=\"1.2\" fill=\"%s\" fill-opacity=\".16\""
                                .formatted(Colors.hex(ink), Colors.hex(ink)),
                x,
                y,
                width,
                height);
    }

    private void rectangle(String paint, double x, double y, double width, double height) {
        add("<rect %s x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"/>"
                .formatted(paint, number(x), number(y), number(width), number(height)));
    }

    @Override
    public void dot(double x, double y, double radius, Ink ink) {
        circle(fill(ink), x, y, radius);
    }

    @Override
    public void ring(double x, double y, double radius, Ink ink) {
        circle(stroke(ink), x, y, radius);
    }

    private void circle(String paint, double x, double y, double radius) {
        add("<circle %s cx=\"%s\" cy=\"%s\" r=\"%s\"/>".formatted(paint, number(x), number(y), number(radius)));
    }

    @Override
    public void text(double x, double y, String text, Align align, Ink ink) {
        add("<text %s x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>"
                .formatted(fill(ink), number(x), number(y), align.name().toLowerCase(Locale.ROOT), Html.text(text)));
    }

    private String stroke(Ink ink) {
        return inPage
                ? "class=\"stroke %s\"".formatted(ink.word())
                : "stroke=\"%s\" fill=\"none\"".formatted(Colors.hex(ink));
    }

    private String fill(Ink ink) {
        return inPage ? "class=\"fill %s\"".formatted(ink.word()) : "fill=\"%s\"".formatted(Colors.hex(ink));
    }

    private void add(String element) {
        svg.append(element).append('\n');
    }

    private static String number(double value) {
        return value == Math.rint(value) ? Long.toString((long) value) : String.format(Locale.ROOT, "%.1f", value);
    }
}
