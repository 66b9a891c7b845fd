package rsal.cli.bench;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.DoubleSummaryStatistics;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.DoubleStream;
import rsal.bench.measurement.Plot;
import rsal.bench.measurement.Result;
import rsal.cli.terminal.Unreachable;
import tools.jackson.databind.json.JsonMapper;

/// A page of what benchmarks measured, with plots by Vega-Lite. It carries all that it needs, so that it can be sent
/// to others and read without a network.
final class BenchPage {
    private static final String SCHEMA = "https://vega.github.io/schema/vega-lite/v6.json";
    private static final double FAR_APART = 30; // times the least
    private static final String STYLE = """
            :root { color-scheme: light dark; font: 15px/1.5 system-ui, sans-serif; }
            body { max-width: 70rem; margin: 2rem auto; padding: 0 1rem; }
            h1 { font-size: 1.5rem; } h2 { font-size: 1.15rem; margin-top: 2.5rem; }
            table { border-collapse: collapse; }
            th, td { padding: 0.2rem 0.8rem; text-align: right; border-bottom: 1px solid color-mix(in srgb, currentColor 20%, transparent); }
            th:first-child, td:first-child { text-align: left; font-family: ui-monospace, monospace; }
            figure { margin: 1rem 0; }
            figure, .table { overflow-x: auto; }
            footer { margin-top: 3rem; opacity: 0.75; }
            """;

    private final Path file;
    private final String script;

    private BenchPage(Path file, String script) {
        this.file = file;
        this.script = script;
    }

    /// Looks before anything is measured whether the page can be written.
    static BenchPage at(Path file) {
        Path folder = file.toAbsolutePath().getParent();
        if (Files.isDirectory(file) || folder == null || !Files.isWritable(folder)) {
            throw new Unreachable(
                    "A page can't be written to '%s'. Name a file in a folder that you may write to.".formatted(file));
        }
        Path script = Path.of(System.getProperty("rsal.page", "")).resolve("plots.js");
        try {
            return new BenchPage(file, Files.readString(script));
        } catch (IOException e) {
            throw new Unreachable(
                    "Plots need a script that is built with the page, and '%s' can't be read. './rsal doctor' shows what is missing."
                            .formatted(script));
        }
    }

    void write(String area, List<Result> results, List<Plot> plots, BenchCommand.Machine machine) {
        try {
            Files.writeString(file, html(area, results, plots, machine));
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    private String html(String area, List<Result> results, List<Plot> plots, BenchCommand.Machine machine) {
        var html = new StringBuilder("<!doctype html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n")
                .append("<meta name=\"viewport\" content=\"width=device-width\">\n<title>RSAL bench ")
                .append(area)
                .append("</title>\n<style>\n")
                .append(STYLE)
                .append("</style>\n</head>\n<body>\n<h1>RSAL bench ")
                .append(area)
                .append("</h1>\n");
        for (Plot plot : plots) {
            html.append("<h2>")
                    .append(text(plot.title()))
                    .append("</h2>\n<figure>\n<script type=\"application/json\">");
            html.append(new JsonMapper().writeValueAsString(specification(plot)).replace("</", "<\\/"));
            html.append("</script>\n</figure>\n");
        }
        html.append(
                "<h2>All results</h2>\n<div class=\"table\" tabindex=\"0\">\n<table>\n<tr><th>name<th>median<th>unit<th>least<th>most<th>to reach</tr>\n");
        for (Result result : results) {
            html.append("<tr><td>%s<td>%s<td>%s<td>%s<td>%s<td>%s</tr>%n"
                    .formatted(
                            text(result.name()),
                            BenchCommand.number(result.value()),
                            text(result.unit()),
                            BenchCommand.number(result.least()),
                            BenchCommand.number(result.most()),
                            result.goal().map(BenchCommand::number).orElse("")));
        }
        return html.append("</table>\n</div>\n<footer>")
                .append(text(machine.toString()))
                .append("</footer>\n<script>")
                .append(script.replace("</script", "<\\/script"))
                .append("</script>\n</body>\n</html>\n")
                .toString();
    }

    /// A plot as Vega-Lite has it.
    static Map<String, Object> specification(Plot plot) {
        var specification = new LinkedHashMap<String, Object>();
        specification.put("$schema", SCHEMA);
        specification.put("background", "transparent");
        switch (plot) {
            case Plot.Lines lines -> {
                specification.put("width", 800);
                specification.put("height", 300);
                specification.put("data", Map.of("values", lines.points()));
                specification.put("mark", Map.of("type", "line", "tooltip", true));
                specification.put(
                        "encoding",
                        Map.of(
                                "x", axis("x", lines.x(), "quantitative"),
                                "y",
                                        quantity(
                                                "y",
                                                lines.y(),
                                                isLogarithmic(
                                                        lines.y(),
                                                        lines.points().stream().mapToDouble(Plot.Lines.Point::y))),
                                "color", Map.of("field", "series", "title", "")));
            }
            case Plot.Bars bars -> {
                specification.put("width", Map.of("step", 24));
                specification.put("height", 300);
                specification.put("data", Map.of("values", bars.bars()));
                boolean logarithmic =
                        isLogarithmic(bars.y(), bars.bars().stream().mapToDouble(Plot.Bars.Bar::value));
                specification.put(
                        "mark",
                        logarithmic // where a bar would begin anywhere, and its length mean nothing
                                ? Map.of("type", "point", "filled", true, "size", 80, "tooltip", true)
                                : Map.of("type", "bar", "tooltip", true));
                specification.put(
                        "encoding",
                        Map.of(
                                "x", axis("name", bars.x(), "nominal"),
                                "xOffset", Map.of("field", "series"),
                                "y", quantity("value", bars.y(), logarithmic),
                                "color", Map.of("field", "series", "title", "")));
            }
            case Plot.Shares shares -> {
                specification.put("width", Map.of("step", 16));
                specification.put("height", Map.of("step", 24));
                specification.put("data", Map.of("values", shares.shares()));
                specification.put("mark", Map.of("type", "rect", "tooltip", true));
                specification.put(
                        "encoding",
                        Map.of(
                                "x", axis("column", shares.x(), "nominal"),
                                "y", axis("row", shares.y(), "nominal"),
                                "color",
                                        Map.of(
                                                "field",
                                                "value",
                                                "title",
                                                shares.value(),
                                                "type",
                                                "quantitative",
                                                "scale",
                                                Map.of("domain", List.of(0, 1), "scheme", "viridis"))));
            }
        }
        return specification;
    }

    /// Whether values are times so far apart that the short ones would lie on the axis of a linear scale.
    private static boolean isLogarithmic(String title, DoubleStream values) {
        DoubleSummaryStatistics all = values.summaryStatistics();
        return (title.endsWith("[ms]") || title.endsWith("[s]"))
                && all.getMin() > 0
                && all.getMax() > FAR_APART * all.getMin();
    }

    private static Map<String, Object> quantity(String field, String title, boolean logarithmic) {
        Map<String, Object> axis = axis(field, title, "quantitative");
        if (logarithmic) {
            axis.put("scale", Map.of("type", "log"));
        }
        return axis;
    }

    private static Map<String, Object> axis(String field, String title, String type) {
        var axis = new LinkedHashMap<String, Object>(Map.of("field", field, "title", title, "type", type));
        if (type.equals("nominal")) {
            axis.put("sort", null); // as they come
            axis.put("axis", Map.of("labelAngle", -35));
        }
        return axis;
    }

    private static String text(String plain) {
        return plain.replace("&", "&amp;").replace("<", "&lt;");
    }
}
