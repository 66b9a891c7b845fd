package rsal.experiment.report;

import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import rsal.scenario.text.CsvLine;

/// A table of a report, for people and for programs.
///
/// @param name of its files
/// @param words how many of the first columns are words, to the left; those after are numbers, to the right
/// @param header of the columns for people
/// @param rows rounded, for people
/// @param fields names of the columns for programs
/// @param exact rows for programs
record DataTable(
        String name,
        String caption,
        int words,
        List<String> header,
        List<List<String>> rows,
        List<String> fields,
        List<List<String>> exact) {
    DataTable {
        name = ReportFigure.fileName(name);
        header = List.copyOf(header);
        rows = List.copyOf(rows);
        fields = List.copyOf(fields);
        exact = List.copyOf(exact);
    }

    String html() {
        return Html.table(caption, words, header, rows);
    }

    String csv() {
        return Stream.concat(Stream.of(fields), exact.stream())
                .map(row -> CsvLine.of(row.stream()))
                .collect(Collectors.joining());
    }

    /// A `table` for a paper, which needs the package booktabs.
    String latex() {
        String columns = IntStream.range(0, header.size())
                .mapToObj(i -> i < words ? "l" : "r")
                .collect(Collectors.joining());
        return """
                %% Needs \\usepackage{booktabs}.
                \\begin{table}
                  \\centering
                  \\caption{%s}
                  \\label{tab:%s}
                  \\begin{tabular}{%s}
                    \\toprule
                %s
                    \\midrule
                %s
                    \\bottomrule
                  \\end{tabular}
                \\end{table}
                """.formatted(
                        Latex.text(caption),
                        name,
                        columns,
                        line(header),
                        rows.stream().map(DataTable::line).collect(Collectors.joining("\n")));
    }

    private static String line(List<String> cells) {
        return "    " + cells.stream().map(Latex::text).collect(Collectors.joining(" & ")) + " \\\\";
    }
}
