package rsal.experiment.report;

import java.util.List;

/// Pieces of a page.
final class Html {
    private Html() {}

    static String text(String plain) {
        return plain.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }

    /// A table of plain texts. The first cell of each row says what the row is of.
    ///
    /// @param caption what it is about
    /// @param words how many of the first columns are words, to the left; those after are numbers, to the
    /// right
    static String table(String caption, int words, List<String> header, List<List<String>> rows) {
        return table(caption, words, header, rows, List.of());
    }

    /// @param links where the first cell of each row leads to; none when nowhere
    static String table(String caption, int words, List<String> header, List<List<String>> rows, List<String> links) {
        var html = new StringBuilder(
                "<div class=\"wide\" role=\"region\" tabindex=\"0\" aria-label=\"%s\">\n<table>\n<caption>%s</caption>\n<thead><tr>"
                        .formatted(text(caption), text(caption)));
        for (int i = 0; i < header.size(); i++) {
            html.append("<th scope=\"col\"%s>%s</th>".formatted(style(i, words), text(header.get(i))));
        }
        html.append("</tr></thead>\n<tbody>\n");
        for (int j = 0; j < rows.size(); j++) {
            List<String> row = rows.get(j);
            html.append("<tr>");
            for (int i = 0; i < row.size(); i++) {
                String cell = text(row.get(i));
                html.append((i == 0 ? "<th scope=\"row\"%s>%s</th>" : "<td%s>%s</td>")
                        .formatted(
                                style(i, words),
                                i == 0 && !links.isEmpty()
                                        ? "<a href=\"%s\">%s</a>".formatted(text(links.get(j)), cell)
                                        : cell));
            }
            html.append("</tr>\n");
        }
        return html.append("</tbody>\n</table>\n</div>\n").toString();
    }

    private static String style(int column, int words) {
        return column < words ? " class=\"words\"" : "";
    }
}
